// Soil that softens while it flows: what a flow has worn out fails at factors that untouched soil bears.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/trial.h"
#include "sample_scene.h"
#include "validation/solve.h"

namespace vbgpd {
namespace {

TEST(StrengthReduction, OfSoilThatSoftensIsThatOfUntouchedSoil) {
  // a weak band of sand, psi = 0: overshot by far, its flow fails 4 % below what the section bears
  const JobResult result = solve(sample_scene("cheng_62c"), 2);
  ASSERT_EQ(result.status, "THIN_LAYER") << result.reason;
  double worn_out = result.srf_stable, started = 0;
  for (const Trial& t : result.trials) {
    if (t.level != 1 || t.verdict != Verdict::kFailed) continue;
    if (t.strength_reduction_factor < worn_out) worn_out = t.strength_reduction_factor, started = t.displacement_level;
  }
  EXPECT_LT(worn_out, 0.98 * result.srf_stable);
  const Trial& last = result.trials.back();  // from gravity
  EXPECT_EQ(last.strength_reduction_factor, result.srf_unstable);
  EXPECT_EQ(last.verdict, Verdict::kFailed);
  EXPECT_LT(last.displacement_level, started / 2);
}

TEST(StrengthReduction, TakesAFlowThatKeepsItsStrengthAtItsWord) {
  // force gathers while the flow sets in, but F_e is what it was: nothing has to be shown twice
  SceneDef scene = sample_scene("cheng_63");
  scene.spacing *= 2;
  const JobResult result = solve(scene, 1);
  ASSERT_EQ(result.status, "OK") << result.reason;
  const Trial& last = result.trials.back();
  EXPECT_EQ(last.verdict, Verdict::kFailed);
  EXPECT_GT(last.unbalanced_force_slope, 0.5);
  EXPECT_GT(last.displacement_level, 12);
  EXPECT_EQ(std::count_if(result.trials.begin(), result.trials.end(),
                          [](const Trial& t) { return t.verdict == Verdict::kFailed; }),
            1);
}

}  // namespace
}  // namespace vbgpd
