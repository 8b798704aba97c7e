// Soil that should stand still does, with the stress that gravity alone decides.
#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

TEST(RunoutStatics, ReleasedBlockStaysAtRestUnderItsWeight) {
  MaterialDef sand = soil("drucker_prager", 0, 30);
  sand.young_modulus = 1000 * sand.unit_weight * 1.0;  // E / gamma H = 1000
  const double height = 1, rows = 20;
  const auto s = runout(block(sand, height, height, height / rows));
  load_by_gravity(*s, 1e-6);
  const double fall = std::sqrt(height / 9.81);
  ASSERT_EQ(s->step(static_cast<std::int64_t>(10 * fall / s->get("time_step")), nullptr).status, Status::kOk);
  const std::vector<double> x = field(*s, "position"), stress = field(*s, "stress");
  double interior = 0, first_row = 0;
  for (std::size_t i = 0; i < x.size() / 2; ++i) {
    const double y = x[2 * i + 1];
    const double error = std::fabs(stress[4 * i + 1] + 20e3 * (height - y)) / (20e3 * height);
    if (y < height / rows) first_row = std::max(first_row, error);
    else if (y < height - height / rows) interior = std::max(interior, error);
  }
  EXPECT_LT(interior, 0.015);
  EXPECT_LT(first_row, 0.03);
  EXPECT_LT(s->get("max_velocity"), 1e-3 * std::sqrt(9.81 * height));
}

TEST(RunoutStatics, CornersOfTheBlockSeeAFullWorldBehindTheWalls) {
  // the moment matrix is that of the bulk next to walls and corners: a linear velocity gradient is exact, and the
  // lateral stress of an elastic block is nu/(1-nu) of the vertical one right into the corner
  MaterialDef m = soil("elastic", 0, 0);
  m.young_modulus = 2e7;
  const auto s = runout(block(m, 1, 1, 0.1));
  load_by_gravity(*s, 1e-7);
  const std::vector<double> stress = field(*s, "stress"), x = field(*s, "position");
  for (std::size_t i = 0; i < x.size() / 2; ++i)
    if (x[2 * i + 1] < 0.8) {
      EXPECT_NEAR(stress[4 * i], 0.3 / 0.7 * stress[4 * i + 1], 0.02 * 20e3) << x[2 * i];
    }
}

}  // namespace
}  // namespace vbgpd::test
