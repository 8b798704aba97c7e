// Soil that softens while it flows: what a flow has worn out fails at factors that untouched soil bears.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/job.h"
#include "sample_scene.h"

namespace vbgpd {
namespace {

JobResult solved(const char* name, double spacing, int levels) {
  SceneDef scene = sample_scene(name);
  scene.spacing *= spacing;
  const auto simulation = Simulation::compile(scene, {});
  const auto job = make_strength_reduction(*simulation);
  job->set("levels", levels);
  EXPECT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  return job->result();
}

TEST(StrengthReduction, OfSoilThatSoftensIsThatOfUntouchedSoil) {
  // a weak band of sand, psi = 0: overshot by far, its flow fails 4 % below what the section bears
  const JobResult result = solved("cheng_62c", 1, 2);
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
  const JobResult result = solved("cheng_63", 2, 1);
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
