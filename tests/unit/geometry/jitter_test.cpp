// Particles off the lattice stay where their cell is.
#include "geometry/jitter.h"

#include <gtest/gtest.h>

#include "sections.h"

namespace vbgpd::geometry_test {
namespace {

Section jittered(Polygon exterior, double amplitude) {
  SceneDef scene = scene_of(std::move(exterior));
  scene.jitter = amplitude;
  return cut(scene, 0.5, 3);
}

TEST(Jitter, LeavesEveryParticleInItsCell) {
  const Section section = jittered(slope(), 0.4);
  ASSERT_EQ(section.shifts.size(), section.seeds.size());
  Real largest = 0;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Vec2 cells = section.shifts[k].cwiseQuotient(section.lattice.spacing);
    largest = std::max(largest, cells.cwiseAbs().maxCoeff());
    EXPECT_EQ(section.place(k), section.lattice.origin + section.local_place(k));
  }
  EXPECT_LE(largest, 0.4);
  EXPECT_GT(largest, 0.39);
}

TEST(Jitter, LeavesWallsAndCutCellsInTheMiddle) {
  const Section section = jittered(slope(), 0.4);
  int walls = 0, cut_cells = 0, moved = 0;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& s = section.seeds[k];
    const bool wall = s.hold != Hold::kFree, whole = s.volume > (1 - 1e-9) * section.lattice.spacing.prod();
    if (!wall && whole) {
      EXPECT_NE(section.shifts[k], Vec2(0, 0));
      ++moved;
      continue;
    }
    EXPECT_EQ(section.shifts[k], Vec2(0, 0));
    ++(wall ? walls : cut_cells);
  }
  EXPECT_GT(walls, 50);
  EXPECT_GT(cut_cells, 10);
  EXPECT_GT(moved, 500);
}

TEST(Jitter, HasNoMeanAndTheVarianceOfAUniformDistribution) {
  const Section section = jittered({{0, 0}, {60, 0}, {60, 60}, {0, 60}}, 0.3);
  Vec2 sum = Vec2::Zero();
  Real square = 0, product = 0;
  double n = 0;
  for (const Vec2& shift : section.shifts) {
    if (shift == Vec2(0, 0)) continue;
    const Vec2 cells = shift.cwiseQuotient(section.lattice.spacing) / 0.3;
    sum += cells, square += cells.squaredNorm() / 2, product += cells.prod(), ++n;
  }
  ASSERT_GT(n, 10000);
  const double noise = 4 / std::sqrt(n);  // four standard deviations of a mean of numbers below 1
  EXPECT_LT(sum.norm() / n, noise);
  EXPECT_NEAR(square / n, 1.0 / 3, noise);
  EXPECT_NEAR(product / n, 0, noise);
}

TEST(Jitter, OfACellDoesNotDependOnPlaceOrSize) {
  const Section here = jittered(slope(), 0.25);
  SceneDef scene = scene_of(moved(scaled(slope(), 2), 5e5, 4e6));
  scene.jitter = 0.25;
  const Section there = cut(scene, 1.0, 3);
  ASSERT_EQ(here.shifts.size(), there.shifts.size());
  for (std::size_t k = 0; k < here.shifts.size(); ++k) EXPECT_LT((2 * here.shifts[k] - there.shifts[k]).norm(), 1e-8);
}

TEST(Jitter, OfNothingHasNoBytes) { EXPECT_EQ(jittered(slope(), 0).shifts.capacity(), 0u); }

}  // namespace
}  // namespace vbgpd::geometry_test
