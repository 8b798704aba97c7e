#include "geometry/clip.h"

#include <gtest/gtest.h>

#include <vector>

namespace vbgpd {
namespace {

const Vertices kComb = {Vec2(0, 0), Vec2(6, 0), Vec2(6, 4), Vec2(5, 4), Vec2(5, 1), Vec2(4, 1),
                        Vec2(4, 4), Vec2(2, 4), Vec2(2, 1), Vec2(1, 1), Vec2(1, 4), Vec2(0, 4)};

TEST(Clip, AConcavePolygonInSeveralPiecesKeepsItsAreaAndMoments) {
  Vertices above, below;
  clip(kComb, 1, 2, false, above);
  clip(kComb, 1, 2, true, below);
  EXPECT_NEAR(signed_area(above), 2 * (1 + 2 + 1), 1e-14);  // three teeth
  EXPECT_NEAR(moments_of(above).first.x(), 2 * (0.5 + 2 * 3 + 5.5), 1e-13);
  EXPECT_NEAR(signed_area(above) + signed_area(below), signed_area(kComb), 1e-13);
}

TEST(Clip, EveryCellOfTheCombIsVisitedOnceWithItsArea) {
  Lattice lattice;
  lattice.spacing = Vec2(1.5, 0.8);
  const GridLines grid = make_grid(lattice, kComb, {}, 0);
  ASSERT_EQ(grid.columns(), 4);
  ASSERT_EQ(grid.rows(), 5);
  std::vector<std::vector<Real>> area(4, std::vector<Real>(5, 0));
  int visits = 0;
  CellVisitor visit;
  visit.full = [&](Index column, Index begin, Index end) {
    for (Index row = begin; row < end; ++row, ++visits) area[column][row] += 1.5 * 0.8;
  };
  visit.partly = [&](Index column, Index row, const Vertices& outline) {
    area[column][row] += signed_area(outline);
    ++visits;
  };
  cut_by_grid(kComb, grid, visit);
  EXPECT_EQ(visits, 20);
  EXPECT_NEAR(area[0][0], 1.2, 1e-14);              // full
  EXPECT_NEAR(area[0][1], 1.5 * 0.2 + 0.6, 1e-14);  // floor of the gap at y = 1
  EXPECT_NEAR(area[0][3], 0.8, 1e-14);              // tooth from 0 to 1 only
  EXPECT_NEAR(area[1][3], 0.8, 1e-14);              // tooth from 2 to 3
}

TEST(Clip, LinesMoveOntoVerticesThatMissThemByRoundOff) {
  Lattice lattice;
  lattice.spacing = Vec2(1, 1);
  const Vertices polygon = {Vec2(0, 0), Vec2(3, 0), Vec2(3, 2 + 1e-12), Vec2(0, 2)};
  const GridLines grid = make_grid(lattice, polygon, {}, 0);
  EXPECT_EQ(grid.rows(), 2);
  EXPECT_EQ(grid.y.back(), 2 + 1e-12);
}

}  // namespace
}  // namespace vbgpd
