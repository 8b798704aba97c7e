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

TEST(RunoutRest, AnEndTimeBeforeThatIsSaidWithTheEnergyThatIsLeft) {
  const auto s = runout(bar_column(8));
  const auto job = make_runout_job(*s);
  job->set("end_time", 0.1);
  ASSERT_EQ(job->run(0, {}), Status::kOk);
  EXPECT_EQ(job->result().status, "TIME_REACHED");
  EXPECT_NE(job->result().reason.find("of its peak"), std::string::npos) << job->result().reason;
}

TEST(RunoutLoad, PressesNothingUp) {
  SceneDef scene = slope(soil("mohr_coulomb", 10e3, 20), 1);
  LoadDef load;
  load.x0 = 2, load.x1 = 10, load.pressure = load.pressure_end = 50e3;
  scene.loads = {load};
  const auto s = runout(scene);
  double total = 0;
  for (std::size_t id = 0; id < static_cast<std::size_t>(s->particle_count()); ++id) {
    EXPECT_LT(s->model().force_y[id], 0) << id;
    total -= s->model().force_y[id];
  }
  EXPECT_NEAR(total, 220 * 20e3 + 8 * 50e3, 1);
}

TEST(RunoutWalls, SoilThatWentThroughAHollowCornerIsPushedBack) {
  SceneDef scene = block(soil("mohr_coulomb", 10e3, 20), 1, 1, 0.1);
  for (BoundaryDef& b : scene.boundaries) b.kind = BoundaryKind::kRoller;
  const auto s = runout(scene);
  FlowState& state = s->state();
  std::size_t corner = 0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(s->particle_count()); ++i)
    if (state.motion[4 * i] + state.motion[4 * i + 1] < state.motion[4 * corner] + state.motion[4 * corner + 1])
      corner = i;
  const double id = state.particle[corner];
  state.motion[4 * corner] = state.motion[4 * corner + 1] = -0.02;
  s->state_was_changed();
  s->step(200, nullptr);
  for (std::size_t i = 0; i < static_cast<std::size_t>(s->particle_count()); ++i)
    if (s->state().particle[i] == id) {
      EXPECT_GT(s->state().motion[4 * i], 0);
      EXPECT_GT(s->state().motion[4 * i + 1], 0);
    }
}

}  // namespace
}  // namespace vbgpd::test
