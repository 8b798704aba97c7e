// When a run-out is over: at rest after a slide, however it is sliced, or because the slope stands.
#include <gtest/gtest.h>

#include "analysis/job.h"
#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

TEST(RunoutRest, IsSeenInShortPiecesToo) {
  const auto s = runout(bar_column(8));
  double time = 0;
  std::string status;
  while (time < 2 && status != "AT_REST") {
    const auto job = make_runout_job(*s);
    job->set("end_time", time += 0.05);
    ASSERT_EQ(job->run(0, {}), Status::kOk);
    status = job->result().status;
  }
  EXPECT_EQ(status, "AT_REST");
  EXPECT_LT(s->get("kinetic_energy"), 1e-6 * s->get("peak_kinetic_energy"));
}

TEST(RunoutRest, ADrivenModelIsGivenTimeToSetOutAgain) {
  const auto s = runout(bar_column(8));
  ASSERT_EQ(make_runout_job(*s)->run(0, {}), Status::kOk);
  const double before = s->get("time"), moved = s->get("max_displacement");
  s->set("kh", 0.3);
  const auto job = make_runout_job(*s);
  job->set("end_time", before + 0.3);
  ASSERT_EQ(job->run(0, {}), Status::kOk);
  EXPECT_GT(s->get("time"), before + 0.1);
  EXPECT_GT(s->get("max_displacement"), moved + 0.005);
}

TEST(RunoutRest, ASlopeThatStandsIsSaidToStand) {
  const auto s = runout(slope(soil("mohr_coulomb", 10e3, 20), 1));
  s->set("strength_reduction_factor", 1.2);
  const auto job = make_runout_job(*s);
  ASSERT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  EXPECT_EQ(job->result().status, "AT_REST");
  EXPECT_NE(job->result().reason.find("the slope stands"), std::string::npos) << job->result().reason;
  EXPECT_EQ(job->result().moved_area, 0);
  EXPECT_LT(s->get("time"), 20 * std::sqrt(10 / 9.81));
}

TEST(RunoutRest, AStandingSlopeThatIsDrivenIsGivenTimeToSetOut) {
  const auto s = runout(slope(soil("mohr_coulomb", 10e3, 20), 1));
  s->set("damping", 0.3);
  ASSERT_EQ(make_runout_job(*s)->run(0, {}), Status::kOk);
  const double before = s->get("time");
  EXPECT_LT(s->get("max_displacement"), 0.1);
  s->set("damping", 0), s->set("strength_reduction_factor", 2);
  const auto job = make_runout_job(*s);
  ASSERT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  EXPECT_GT(s->get("time"), before + 1) << job->result().reason;
  EXPECT_GT(s->get("max_displacement"), 1);
}

TEST(RunoutRest, AnEndTimeBeforeThatIsSaidWithTheEnergyThatIsLeft) {
  const auto s = runout(bar_column(8));
  const auto job = make_runout_job(*s);
  job->set("end_time", 0.1);
  ASSERT_EQ(job->run(0, {}), Status::kOk);
  EXPECT_EQ(job->result().status, "TIME_REACHED");
  EXPECT_NE(job->result().reason.find("of its peak"), std::string::npos) << job->result().reason;
}

}  // namespace
}  // namespace vbgpd::test
