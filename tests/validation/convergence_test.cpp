// Error against run time of one scene: the vertical cut, whose exact factor of safety is 1.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/job.h"
#include "analysis/trial.h"
#include "sample_scene.h"

namespace vbgpd {
namespace {

SceneDef vertical_cut(double spacing) {
  SceneDef s = sample_scene("vertical_cut");
  s.spacing = spacing;
  return s;
}

struct Solved {
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<Job> job;
  Status status = Status::kOk;
};

Solved solve(const SceneDef& s, std::initializer_list<std::pair<const char*, double>> options,
             const CompileOptions& compile = {}) {
  Solved r;
  r.simulation = Simulation::compile(s, compile);
  r.job = make_strength_reduction(*r.simulation);
  for (const auto& [name, value] : options) r.job->set(name, value);
  r.status = r.job->run(0, {});
  return r;
}

double spacing(const Level& l) { return std::sqrt(l.spacing_x * l.spacing_y); }

TEST(TargetError, IsMetByFinerGridsThanTheScenesAndHolds) {
  const Solved r = solve(vertical_cut(1.25), {{"target_error", 0.02}});
  const JobResult& result = r.job->result();
  EXPECT_EQ(r.status, Status::kOk);
  EXPECT_EQ(result.status, "OK") << result.reason;
  EXPECT_LE(result.error_estimate, 0.02);
  EXPECT_LE(std::fabs(result.factor_of_safety - 1), result.error_estimate);
  ASSERT_GE(result.levels.size(), 3u);
  EXPECT_LT(spacing(result.levels.back()), 1.1);  // finer than the scene's 1.25 m
  for (std::size_t k = 0; k + 1 < result.levels.size(); ++k)
    EXPECT_FALSE(k > 0 && result.levels[k].error_estimate <= 0.02) << "went on past its target";
}

TEST(TargetError, OutOfReachIsSaidSoWithTheBestValue) {
  const Solved r = solve(vertical_cut(1.25), {{"target_error", 0.001}, {"levels", 3}});
  const JobResult& result = r.job->result();
  EXPECT_EQ(r.status, Status::kNotConverged);
  EXPECT_NE(result.status, "OK");
  EXPECT_NE(result.reason.find("the target of 0.001 is not met"), std::string::npos) << result.reason;
  EXPECT_EQ(result.levels.size(), 3u);
  EXPECT_NEAR(result.factor_of_safety, 1, result.error_estimate);
  EXPECT_GT(result.error_estimate, 0.001);
}

TEST(TargetError, StopsAtTheLimitOfParticles) {
  CompileOptions limit;
  limit.max_particles = 1000;
  const Solved r = solve(vertical_cut(1.25), {{"target_error", 0.001}}, limit);
  EXPECT_EQ(r.status, Status::kNotConverged);
  EXPECT_EQ(r.job->result().status, "TARGET_NOT_MET");
  EXPECT_NE(r.job->result().reason.find("more than the 1000 allowed"), std::string::npos) << r.job->result().reason;
  for (const Level& l : r.job->result().levels) EXPECT_LE(l.particles, 1000);
}

TEST(Budget, IsKeptAndUsedAndTheNextGridPredicted) {
  constexpr double kBudget = 4;
  const Solved r = solve(vertical_cut(1.25), {{"budget", kBudget}});
  const JobResult& result = r.job->result();
  EXPECT_EQ(r.status, Status::kOk) << result.reason;
  EXPECT_GE(result.levels.size(), 2u);
  EXPECT_LT(result.wall_seconds, kBudget + 0.5);  // a slice and the slip surface may run over
  double seconds = 0;
  for (const Level& l : result.levels) seconds += l.wall_seconds;
  EXPECT_NEAR(seconds, result.wall_seconds, 0.1 * result.wall_seconds + 0.05);
  EXPECT_LT(result.next_level_spacing, spacing(result.levels.back()));
  EXPECT_GT(result.next_level_seconds + result.wall_seconds, kBudget);
  EXPECT_NE(result.reason.find("budget"), std::string::npos) << result.reason;
}

TEST(Budget, TooSmallForAnyGridGivesNoValue) {
  const Solved r = solve(vertical_cut(0.2), {{"budget", 0.01}});
  EXPECT_EQ(r.status, Status::kNotConverged);
  EXPECT_EQ(r.job->result().status, "NOT_CONVERGED");
  EXPECT_TRUE(std::isnan(r.job->result().factor_of_safety));
  EXPECT_NE(r.job->result().reason.find("budget ended within grid 1"), std::string::npos) << r.job->result().reason;
}

TEST(StrengthReduction, OfTheSameModelAgainGivesTheSameBits) {
  const Solved first = solve(vertical_cut(1.25), {});
  const std::uint64_t failing = first.simulation->state_hash();
  first.simulation->step(20, nullptr);
  const auto again = make_strength_reduction(*first.simulation);
  EXPECT_EQ(again->run(0, {}), Status::kOk);
  EXPECT_EQ(again->result().factor_of_safety, first.job->result().factor_of_safety);
  EXPECT_EQ(again->result().steps, first.job->result().steps);
  EXPECT_EQ(first.simulation->state_hash(), failing);
}

TEST(StrengthReduction, ShowsTheLowerEndAsATrial) {
  // the highest factor asked stands: found on the way to a flow, by the rules of every other trial
  const Solved r = solve(vertical_cut(1.25), {{"levels", 1}, {"srf_max", 0.8}});
  EXPECT_EQ(r.job->result().status, "ABOVE_MAX") << r.job->result().reason;
  ASSERT_FALSE(r.job->result().trials.empty());
  const Trial& last = r.job->result().trials.back();
  EXPECT_EQ(last.verdict, Verdict::kStable);
  EXPECT_EQ(last.strength_reduction_factor, 0.8);
  EXPECT_EQ(last.strength_reduction_factor, r.job->result().srf_stable);
  EXPECT_LT(last.unbalanced_force_ratio, TrialRules{}.equilibrium);
  EXPECT_GT(last.steps, 10 * TrialRules{}.equilibrium_windows);
  EXPECT_TRUE(std::isnan(last.power_ratio));
}

TEST(Levels, EachIsReportedWithWhatItCostAndWhatItSays) {
  const Solved r = solve(vertical_cut(1.25), {{"levels", 4}});
  const JobResult& result = r.job->result();
  ASSERT_EQ(result.levels.size(), 4u);
  std::int64_t steps = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Level& l = result.levels[k];
    steps += l.steps;
    EXPECT_GT(l.wall_seconds, 0);
    EXPECT_GT(l.bonds, l.particles);
    EXPECT_GE(l.error_estimate, (l.srf_unstable - l.srf_stable) / 2 * 0.999);
    if (k > 0) {
      EXPECT_LT(spacing(l), spacing(result.levels[k - 1]));
    }
  }
  EXPECT_EQ(steps, result.steps);
  EXPECT_EQ(result.factor_of_safety, result.levels.back().estimate);
  EXPECT_EQ(result.error_estimate, result.levels.back().error_estimate);
}

TEST(Levels, AThinLayerIsNamed) {
  SceneDef s = vertical_cut(1.25);
  s.materials.push_back(s.materials[0]);
  s.materials.back().name = "seam", s.materials.back().cohesion *= 0.8;
  s.layers.push_back({"seam", {{0, 8}, {30, 8}, {30, 9}, {0, 9}}});
  const Solved r = solve(s, {});
  EXPECT_EQ(r.job->result().status, "THIN_LAYER");
  EXPECT_NE(r.job->result().reason.find("'seam'"), std::string::npos) << r.job->result().reason;
}

}  // namespace
}  // namespace vbgpd
