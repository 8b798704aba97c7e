// Dry faces of sand without cohesion fail as a skin, like an infinite slope: FS = tan(phi) / tan(beta).
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/job.h"

namespace vbgpd {
namespace {

/// Face of 10 m in `run` : 1 on 5 m of the same sand.
SceneDef face(double friction_angle, double run, double spacing = 0.5) {
  SceneDef s;
  MaterialDef sand;
  sand.name = "sand", sand.unit_weight = 18e3, sand.cohesion = 0, sand.friction_angle = friction_angle;
  s.materials = {sand};
  const double toe = 15 + 10 * run, end = toe + 20;
  s.exterior = {{0, 0}, {end, 0}, {end, 5}, {toe, 5}, {15, 15}, {0, 15}};
  s.layers = {{"sand", {}}};
  s.spacing = spacing;
  return s;
}

struct Face {
  double friction_angle, run;
};
void PrintTo(const Face& f, std::ostream* out) { *out << "phi " << f.friction_angle << ", " << f.run << ":1"; }

class SandFace : public testing::TestWithParam<Face> {};
INSTANTIATE_TEST_SUITE_P(All, SandFace,
                         testing::Values(Face{30, 1.5}, Face{36, 1.5}, Face{36, 2}, Face{40, 2}, Face{36, 3}));

TEST_P(SandFace, FailsLikeAnInfiniteSlopeAndSaysThatItsSkinIsThin) {
  const auto [friction_angle, run] = GetParam();
  const double exact = std::tan(friction_angle * std::acos(-1) / 180) * run;
  const auto simulation = Simulation::compile(face(friction_angle, run), {});
  const auto job = make_strength_reduction(*simulation);
  ASSERT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  const JobResult& result = job->result();
  RecordProperty("ratio", std::to_string(result.factor_of_safety / exact));
  EXPECT_EQ(result.status, "THIN_SLIDE") << result.reason;
  EXPECT_NEAR(result.factor_of_safety / exact, 1, 0.02) << result.reason;
  EXPECT_LE(std::fabs(result.factor_of_safety - exact), result.error_estimate);
  EXPECT_EQ(result.factor_of_safety, result.levels.back().factor_of_safety);
}

TEST(SandFaces, MeetATargetLikeAnyOtherSlope) {
  const auto simulation = Simulation::compile(face(36, 2), {});
  const auto job = make_strength_reduction(*simulation);
  job->set("target_error", 0.2);
  ASSERT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  EXPECT_EQ(job->result().status, "THIN_SLIDE");
  EXPECT_LE(job->result().error_estimate, 0.2);
  EXPECT_EQ(job->result().levels.size(), 2u);
}

/// Flow that is not associated: half the spacing, a thinner skin, a little less strength.
TEST(SandFaces, OfHalfTheSpacingLieAFewPerCentLower) {
  for (const Face& f : {Face{36, 1.5}, Face{40, 2}}) {
    const double exact = std::tan(f.friction_angle * std::acos(-1) / 180) * f.run;
    const auto simulation = Simulation::compile(face(f.friction_angle, f.run, 0.25), {});
    const auto job = make_strength_reduction(*simulation);
    job->set("levels", 1);
    ASSERT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
    EXPECT_LT(job->result().factor_of_safety / exact, 1) << f.friction_angle;
    EXPECT_GT(job->result().factor_of_safety / exact, 0.95) << f.friction_angle;
  }
}

}  // namespace
}  // namespace vbgpd
