// Verdicts of one strength reduction factor, on a coarse slope whose factor of safety is 1.49 (tests/stability).
#include "analysis/trial.h"

#include <gtest/gtest.h>

#include "physics/runout_scenes.h"
#include "physics/scenes.h"

namespace vbgpd {
namespace {

constexpr double kBalances = 1.492;  // F at which the flow of this slope just balances
constexpr std::int64_t kResponse = 130;

/// The slope, flowing well above its factor of safety.
std::unique_ptr<Simulation> flowing() {
  auto simulation = Simulation::compile(test::slope(test::soil("mohr_coulomb", 10e3, 20), 1), {});
  simulation->set("strength_reduction_factor", 1.04 * kBalances);
  simulation->relax(6 * kResponse, {});
  return simulation;
}

Trial tried(Simulation& simulation, double factor, TrialRules rules = {}) {
  simulation.set("strength_reduction_factor", factor);
  rules.drive = 1e-4;
  Trial trial;
  trial.strength_reduction_factor = factor;
  Progress progress;
  constexpr double kElastic = 0.007;  // its elastic displacement in metres
  TrialRun run(simulation, rules, kResponse, kElastic);
  for (Slices s = run.run(trial, progress); s.next();) {
  }
  return trial;
}

TEST(Trial, FlowFailsAboveTheFactorItBalancesAtAndRestsBelow) {
  const auto simulation = flowing();
  const auto flow = simulation->save();
  for (const double above : {0.01, 0.005, 0.002, 0.001}) {
    simulation->restore(*flow);
    const Trial t = tried(*simulation, kBalances + above);
    EXPECT_EQ(t.verdict, Verdict::kFailed) << above;
    EXPECT_TRUE(t.band_connected);
    EXPECT_LT(t.power_ratio, t.strength_reduction_factor);
    EXPECT_NEAR(t.power_ratio, kBalances, 0.001);
    simulation->restore(*flow);
    EXPECT_EQ(tried(*simulation, kBalances - above).verdict, Verdict::kStable) << above;
  }
}

TEST(Trial, FlowTooSlowForABriefLookFailsOnALongOne) {
  const auto simulation = flowing();
  const auto flow = simulation->save();
  TrialRules both;
  both.growth = 1;  // of the elastic displacement: more than this flow grows in one response time
  TrialRules brief = both;
  brief.long_look = 2 * brief.patience;  // never
  EXPECT_EQ(tried(*simulation, kBalances + 0.001, brief).verdict, Verdict::kUndecided);
  simulation->restore(*flow);
  const Trial t = tried(*simulation, kBalances + 0.001, both);
  EXPECT_EQ(t.verdict, Verdict::kFailed);
  EXPECT_GE(t.steps, both.long_look * kResponse);
}

TEST(Trial, UntouchedSoilThatRestsInTheEndHasNotFailedOnItsWay) {
  // a little below its factor of safety it creeps on a plateau of R while F_e rises to F
  for (const double below : {0.007, 0.0045, 0.002}) {
    const auto simulation = Simulation::compile(test::slope(test::soil("mohr_coulomb", 10e3, 20), 1), {});
    test::load_by_gravity(*simulation, 1e-6);
    TrialRules rules;
    rules.patience = 100;
    const Trial t = tried(*simulation, kBalances - below, rules);
    EXPECT_EQ(t.verdict, Verdict::kStable) << below;
    EXPECT_GT(t.steps, 20 * kResponse) << below;
  }
}

TEST(Trial, FlowThatAllButBalancesIsLeftAtOnceWhereAnotherFactorWouldDo) {
  const auto simulation = flowing();
  const auto flow = simulation->save();
  TrialRules brief;
  brief.balanced = 0.001;  // F_e lies 0.0005 below F
  const Trial left = tried(*simulation, kBalances + 0.0005, brief);
  EXPECT_EQ(left.verdict, Verdict::kUndecided);
  EXPECT_GE(left.steps, 2 * kResponse);
  EXPECT_LT(left.steps, brief.patience * kResponse);
  EXPECT_NEAR(left.power_ratio, left.strength_reduction_factor, brief.balanced * kBalances);
  for (const double beside : {0.01, -0.01}) {  // further away it takes nothing from a verdict
    simulation->restore(*flow);
    EXPECT_EQ(tried(*simulation, kBalances + beside, brief).verdict, beside > 0 ? Verdict::kFailed : Verdict::kStable);
  }
}

TEST(Trial, StepLimitIsNoVerdict) {
  const auto simulation = flowing();
  TrialRules rules;
  rules.step_limit = 50;
  EXPECT_EQ(tried(*simulation, kBalances + 0.01, rules).verdict, Verdict::kUndecided);
}

}  // namespace
}  // namespace vbgpd
