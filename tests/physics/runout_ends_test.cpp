// A run-out says where soil moves at an end of the section, beyond which there may be more of it.
#include <gtest/gtest.h>

#include "analysis/job.h"
#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

/// What a run-out says of a 1:1 slope of soft clay, 5 m high, with so much level ground behind its crest.
std::string reason_of(double behind_the_crest) {
  const double crest = behind_the_crest, toe = crest + 5, end = toe + 12;
  SceneDef s = block(soil("undrained", 8e3, 0), end, 7, 0.5);
  s.exterior = {{0, 0}, {end, 0}, {end, 2}, {toe, 2}, {crest, 7}, {0, 7}};
  const auto simulation = runout(s);
  const auto job = make_runout_job(*simulation);
  job->set("end_time", 3);
  EXPECT_EQ(job->run(0, nullptr), Status::kOk);
  EXPECT_GT(job->result().max_displacement, 1);
  return job->result().reason;
}

TEST(RunoutEnds, AreNamedWhereTheSoilThereMoves) {
  const std::string near = reason_of(3), far = reason_of(15);
  EXPECT_NE(near.find("end of the section at x = 0 m"), std::string::npos) << near;
  EXPECT_EQ(far.find("end of the section"), std::string::npos) << far;
}

}  // namespace
}  // namespace vbgpd::test
