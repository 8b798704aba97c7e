// Factors of safety with exact answers, and what must not change them. Spacings as in the scene files.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/job.h"
#include "physics/scenes.h"
#include "sample_scene.h"
#include "validation/solve.h"

namespace vbgpd {
namespace {

TEST(VerticalCut, ExtrapolatesToTheExactStabilityNumberWithinOnePercent) {
  const JobResult r = solve(sample_scene("vertical_cut"), 2);  // gamma H / c = 3.776: exact factor of safety 1
  EXPECT_EQ(r.status, "OK");
  EXPECT_NEAR(r.factor_of_safety, 1, 0.01);
  EXPECT_LE(std::fabs(r.factor_of_safety - 1), r.error_estimate);
}

TEST(PrandtlStrip, ExtrapolatesToTwoPlusPiWithinOnePercent) {
  const JobResult r = solve(sample_scene("prandtl_strip"), 2);  // q = (2 + pi) c: exact factor of safety 1
  EXPECT_EQ(r.status, "OK");
  EXPECT_NEAR(r.factor_of_safety, 1, 0.01);
  EXPECT_LE(std::fabs(r.factor_of_safety - 1), r.error_estimate);
}

TEST(GriffithsLane, ExampleOneLiesWithinOnePercentOfThePublishedSpan) {
  const JobResult r = solve(sample_scene("gl_1"), 2);
  EXPECT_GE(r.factor_of_safety, 1.35 * 0.99);  // strength reduction 1.35 to 1.40, Bishop & Morgenstern 1.38
  EXPECT_LE(r.factor_of_safety, 1.40 * 1.01);
}

/// Limit analysis holds for associated flow. High above FS such a flow runs away, and the search looks further below.
TEST(DawsonSlope, WithAssociatedFlowHasTheFactorOfSafetyOfLimitAnalysis) {
  SceneDef s = sample_scene("dawson_45");
  for (MaterialDef& m : s.materials) m.dilatancy_angle = m.friction_angle;
  const JobResult r = solve(s, 2);
  EXPECT_EQ(r.status, "OK");
  EXPECT_NEAR(r.factor_of_safety, 1, 0.01);  // c / gamma H = 0.0619, phi = 20, 45 degrees (Chen 1975)
  EXPECT_LE(std::fabs(r.factor_of_safety - 1), r.error_estimate);
}

SceneDef small_slope() {
  SceneDef s = sample_scene("gl_1");
  s.spacing = 1;
  return s;
}

void transform(SceneDef& s, double scale, double dx, double dy, bool mirror) {
  for (Point& p : s.exterior) p = {(mirror ? -p.x : p.x) * scale + dx, p.y * scale + dy};
  for (LayerDef& l : s.layers)
    for (Point& p : l.polygon) p = {(mirror ? -p.x : p.x) * scale + dx, p.y * scale + dy};
  for (BoundaryDef& b : s.boundaries)
    if (mirror && !b.side.empty() && b.side != "base") b.side = b.side == "left" ? "right" : "left";
  for (MaterialDef& m : s.materials) m.cohesion *= scale, m.young_modulus *= scale;
  s.spacing *= scale;
}

TEST(FactorOfSafety, IsTheSameForMillimetresAndKilometres) {
  const double base = solve(small_slope(), 1).factor_of_safety;
  for (double scale : {1e-3, 1e3}) {
    SceneDef s = small_slope();
    transform(s, scale, 0, 0, false);
    EXPECT_NEAR(solve(s, 1).factor_of_safety, base, 1e-6) << scale;
  }
}

TEST(FactorOfSafety, IsTheSameForTheMirroredSlope) {
  SceneDef s = small_slope();
  const double base = solve(s, 1).factor_of_safety;
  transform(s, 1, 0, 0, true);
  EXPECT_NEAR(solve(s, 1).factor_of_safety, base, 1e-6);
}

TEST(FactorOfSafety, IsTheSameAtMapCoordinates) {
  SceneDef s = small_slope();
  const double base = solve(s, 1).factor_of_safety;
  transform(s, 1, 512345.25, 5412345.5, false);
  EXPECT_NEAR(solve(s, 1).factor_of_safety, base, 1e-6);
}

TEST(FactorOfSafety, IsTheSameForAnyStiffness) {
  SceneDef s = small_slope();
  const double base = solve(s, 1).factor_of_safety;
  for (double stiffness : {1e6, 1e10}) {
    s.materials[0].young_modulus = stiffness;
    EXPECT_NEAR(solve(s, 1).factor_of_safety, base, 0.01 * base) << stiffness;
  }
}

TEST(FactorOfSafety, IsTheSameForAnyThreadCountAndSlicing) {
  const JobResult one = solve(small_slope(), 2), two = solve(small_slope(), 2, 2);
  EXPECT_EQ(one.factor_of_safety, two.factor_of_safety);
  EXPECT_EQ(one.steps, two.steps);
  const auto simulation = Simulation::compile(small_slope(), {});
  const auto job = make_strength_reduction(*simulation);
  int slices = 0;
  while (job->run(0.001, {}) == Status::kLimitReached) ++slices;
  EXPECT_GT(slices, 3);
  EXPECT_EQ(job->result().factor_of_safety, one.factor_of_safety);
  EXPECT_EQ(job->result().steps, one.steps);
}

TEST(FactorOfSafety, BelowOneIsFoundForASlopeThatCannotStand) {
  SceneDef s = small_slope();
  s.materials[0].cohesion = 3e3, s.materials[0].friction_angle = 10;
  const JobResult r = solve(s, 1);
  EXPECT_EQ(r.status, "OK");
  EXPECT_LT(r.srf_unstable, 1);
  EXPECT_GT(r.srf_stable, 0.4);
}

TEST(FactorOfSafety, OutsideTheRangeAskedIsSaidSo) {
  SceneDef s = small_slope();
  s.strength_reduction.srf_max = 1.2;
  EXPECT_EQ(solve(s, 1).status, "ABOVE_MAX");
  s.strength_reduction.srf_min = 2, s.strength_reduction.srf_max = 3;
  EXPECT_EQ(solve(s, 1).status, "BELOW_MIN");
}

/// 45 degrees, 10 m high on 6 m, without tension. Limit equilibrium (Spencer) with a dry tension crack: 1.087.
SceneDef cracked_slope() {
  SceneDef s = small_slope();
  s.exterior = {{0, 0}, {46, 0}, {46, 6}, {28, 6}, {18, 16}, {0, 16}};
  MaterialDef& m = s.materials[0];
  m.unit_weight = 19e3, m.cohesion = 15e3, m.friction_angle = 20, m.tension_cutoff = 0;
  return s;
}

TEST(FactorOfSafety, OfSoilWithoutTensionIsThatOfACrackedSlope) {
  const JobResult r = solve(cracked_slope(), 1);
  EXPECT_EQ(r.status, "OK") << r.reason;
  EXPECT_GT(r.factor_of_safety, 1.087);  // one coarse grid lies above the limit of fine ones
  EXPECT_LT(r.factor_of_safety, 1.06 * 1.087);
  SceneDef bonded = cracked_slope();
  bonded.materials[0].tension_cutoff = kNone;
  EXPECT_GT(solve(bonded, 1).factor_of_safety, r.factor_of_safety);
}

TEST(FactorOfSafety, BelowTheRangeIsSaidOnlyOfSoilThatNothingHasWornOut) {
  SceneDef s = cracked_slope();
  const double lowest = 1.05;
  s.strength_reduction.srf_min = lowest;
  EXPECT_GT(solve(s, 1).srf_stable, lowest);
}

TEST(FactorOfSafety, IsNotDecidedByAStepLimit) {
  const auto simulation = Simulation::compile(small_slope(), {});
  const auto job = make_strength_reduction(*simulation);
  job->set("step_limit", 20);
  EXPECT_EQ(job->run(0, {}), Status::kNotConverged);
  EXPECT_EQ(job->result().status, "NOT_CONVERGED");
  EXPECT_NE(job->result().reason.find("20 steps"), std::string::npos) << job->result().reason;
}

/// By plain bisection on one grid; step_limit: of a trial, 0 = the usual one.
JobResult solve_carefully(const SceneDef& s, int step_limit = 0) {
  const auto simulation = Simulation::compile(s, {});
  const auto job = make_strength_reduction(*simulation);
  job->set("levels", 1), job->set("careful", 1), job->set("step_limit", step_limit);
  job->run(0, {});
  return job->result();
}

TEST(FactorOfSafety, BracketIsWiderWhereTheSlopeAllButBalancesAndSaysSo) {
  const SceneDef s = test::slope(test::soil("mohr_coulomb", 10e3, 20), 1);
  const JobResult impatient = solve_carefully(s, 4000), patient = solve_carefully(s);
  const double asked = 0.005 + 1e-9, wide = impatient.srf_unstable - impatient.srf_stable;
  ASSERT_EQ(impatient.status, "OK") << impatient.reason;
  ASSERT_EQ(patient.status, "OK") << patient.reason;
  EXPECT_GT(wide, asked);
  EXPECT_LE(wide, 2 * asked);
  EXPECT_NE(impatient.reason.find("wider than 0.005"), std::string::npos) << impatient.reason;
  EXPECT_LE(patient.srf_unstable - patient.srf_stable, asked);
  EXPECT_EQ(patient.reason.find("wider"), std::string::npos) << patient.reason;
  EXPECT_LE(impatient.srf_stable, patient.srf_stable);  // and the narrow bracket lies within
  EXPECT_GE(impatient.srf_unstable, patient.srf_unstable);
}

TEST(FactorOfSafety, ComesWithTheEvidenceOfBothEnds) {
  const JobResult r = solve(small_slope(), 1);
  bool stable = false, failed = false;
  for (const Trial& t : r.trials) {
    if (t.verdict == Verdict::kStable) {
      EXPECT_LT(t.unbalanced_force_ratio, 1e-5);
    }
    if (t.verdict == Verdict::kFailed) {
      EXPECT_GT(t.unbalanced_force_ratio, 3e-5);
      EXPECT_GT(t.displacement_growth, 0.02);
      EXPECT_TRUE(t.band_connected);
    }
    stable |= t.verdict == Verdict::kStable && t.strength_reduction_factor == r.srf_stable;
    failed |= t.verdict == Verdict::kFailed && t.strength_reduction_factor == r.srf_unstable;
  }
  EXPECT_TRUE(stable);
  EXPECT_TRUE(failed);
  EXPECT_LE(r.srf_unstable - r.srf_stable, 0.005 + 1e-12);
}

TEST(FactorOfSafety, AgreesBetweenTheFastAndTheCarefulSearch) {
  for (const char* name : {"gl_1", "gl_5_l0", "slope_60"}) {
    const SceneDef s = sample_scene(name);
    const double fast = solve(s, 1).factor_of_safety;
    EXPECT_NEAR(fast, solve_carefully(s).factor_of_safety, 0.003 * fast) << name;
  }
}

TEST(FactorOfSafety, SaysWhereTheFailingSlopeStillHardens) {
  // a weak undrained band, over which the slope slides ever further
  const JobResult band = solve(sample_scene("gl_3_r0_2"), 1), plain = solve(sample_scene("gl_1"), 1);
  EXPECT_GT(band.levels.back().hardening, 0.005 * band.factor_of_safety) << band.reason;
  EXPECT_NE(band.reason.find("still hardens"), std::string::npos) << band.reason;
  EXPECT_LT(std::fabs(plain.levels.back().hardening), 0.002 * plain.factor_of_safety) << plain.reason;
  EXPECT_EQ(plain.reason.find("still hardens"), std::string::npos) << plain.reason;
}

TEST(SlipSurface, OfExampleOneRunsFromCrestToToe) {
  const JobResult r = solve(sample_scene("gl_1"), 1);
  ASSERT_GE(r.slip_surface.size(), 10u);
  EXPECT_NEAR(r.slip_surface.front().y, 10, 1e-9);  // enters on the crest
  EXPECT_GT(r.slip_surface.front().x, 6);           // critical Bishop circle: 9.4 (own search of the benchmark)
  EXPECT_LT(r.slip_surface.front().x, 11);
  EXPECT_LT(r.slip_surface.back().y, 1.0);  // leaves at the toe
  EXPECT_GT(r.slip_surface.back().x, 29);
  EXPECT_GT(r.sliding_area, 50);
  EXPECT_LT(r.sliding_area, 90);
}

TEST(SlipSurface, MeetsTheGroundWithoutAHook) {
  const JobResult r = solve(sample_scene("gl_1"), 1);
  const auto piece = [&](std::size_t k) {
    return Vec2(r.slip_surface[k + 1].x - r.slip_surface[k].x, r.slip_surface[k + 1].y - r.slip_surface[k].y);
  };
  const auto turn = [&](std::size_t a, std::size_t b) {
    return std::acos(piece(a).normalized().dot(piece(b).normalized())) * 180 / kPi;
  };
  const std::size_t last = r.slip_surface.size() - 2;
  EXPECT_LT(turn(0, 1), 30);
  EXPECT_LT(turn(last - 1, last), 30);
}

}  // namespace
}  // namespace vbgpd
