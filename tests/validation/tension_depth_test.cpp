// Cohesive soil at the crest hangs in tension; a result says so where a crack there would matter.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/job.h"
#include "analysis/tension.h"

namespace vbgpd {
namespace {

struct Solved {
  std::unique_ptr<Simulation> simulation;
  JobResult result;
};

/// A cut 10 m high in one soil on 5 m of the same.
Solved cut(double degrees, double cohesion, double friction_angle, double tension_cutoff) {
  SceneDef s;
  MaterialDef soil;
  soil.name = "soil", soil.law = "mohr_coulomb", soil.unit_weight = 20e3, soil.cohesion = cohesion;
  soil.friction_angle = friction_angle, soil.tension_cutoff = tension_cutoff;
  s.materials = {soil};
  const double toe = 15 + 10 / std::tan(degrees * std::numbers::pi / 180);
  s.exterior = {{0, -5}, {40, -5}, {40, 0}, {toe, 0}, {15, 10}, {0, 10}};
  s.layers = {{"soil", {}}};
  s.spacing = 0.5;
  Solved out{Simulation::compile(s, {}), {}};
  const auto job = make_strength_reduction(*out.simulation);
  job->set("levels", 1);
  EXPECT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  out.result = job->result();
  return out;
}

TEST(TensionDepth, IsThatOfRankinesActiveState) {
  const double cohesion = 25e3, friction_angle = 20, spacing = 0.5;
  const Solved steep = cut(60, cohesion, friction_angle, kNone);
  const double factor = steep.result.factor_of_safety;
  const double reduced = std::atan(std::tan(friction_angle * std::numbers::pi / 180) / factor);
  const double depth = 2 * cohesion / factor / 20e3 * std::tan(std::numbers::pi / 4 + reduced / 2);
  EXPECT_NEAR(tension_depth(*steep.simulation), depth, 1.5 * spacing);
  EXPECT_NE(steep.result.reason.find("hangs in tension"), std::string::npos) << steep.result.reason;
}

TEST(TensionDepth, IsNotNamedWhereItIsSmallOrTheSoilBearsNone) {
  for (const Solved& gentle : {cut(26.57, 10e3, 20, kNone), cut(45, 20e3, 20, 0)})
    EXPECT_EQ(gentle.result.reason.find("hangs in tension"), std::string::npos) << gentle.result.reason;
}

}  // namespace
}  // namespace vbgpd
