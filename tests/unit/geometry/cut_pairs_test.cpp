#include <gtest/gtest.h>

#include "sections.h"

namespace vbgpd::geometry_test {
namespace {

TEST(CutPairs, PlainFacesHaveNone) {
  EXPECT_TRUE(cut(scene_of(slope()), 0.5).cut_pairs.empty());
  EXPECT_TRUE(cut(scene_of(slope_on_foundation()), 0.5).cut_pairs.empty());
  EXPECT_TRUE(cut(scene_of({{0, 0}, {30, 0}, {20, 10}, {0, 10}}), 0.5).cut_pairs.empty());
  // 45 degrees with a foundation: particles on the face graze the air of the toe, they do not see each other through
  // it.
  EXPECT_TRUE(cut(scene_of({{0, 0}, {40, 0}, {40, 5}, {20, 5}, {10, 15}, {0, 15}}), 0.5).cut_pairs.empty());
}

TEST(CutPairs, VerticalToeCutsThePairsAcrossItsCorner) {
  // Spacing 1, toe at (10, 5): floor cells (8, 4) and (9, 3) ... against face cells (10, 5), (10, 6).
  const std::set<CellPair> expected = {{8, 4, 10, 5}, {9, 4, 10, 6}};
  EXPECT_EQ(cut_cells(cut(scene_of(vertical_cut()), 1.0)), expected);
}

TEST(CutPairs, DoNotDependOnSizeOrPlace) {
  const std::set<CellPair> here = cut_cells(cut(scene_of(overhang()), 0.5));
  EXPECT_FALSE(here.empty());
  EXPECT_EQ(cut_cells(cut(scene_of(moved(overhang(), 5e5, 4e6)), 0.5)), here);
  EXPECT_EQ(cut_cells(cut(scene_of(scaled(overhang(), 1e-3)), 0.5e-3)), here);
}

TEST(CutPairs, NoBondCrossesANarrowTrench) {
  // A trench 0.9 wide between x = 5 and 5.9 down to y = 4, cells 1 x 1 from x = 0.
  const Polygon polygon = {{0, 0}, {11, 0}, {11, 10}, {5.9, 10}, {5.9, 4}, {5, 4}, {5, 10}, {0, 10}};
  Lattice lattice;
  lattice.spacing = Vec2(1, 1);
  const Section section = discretise(scene_of(polygon), lattice, 3, 0);
  const std::set<CellPair> pairs = cut_cells(section);
  EXPECT_TRUE(pairs.count({4, 8, 6, 8}));
  EXPECT_TRUE(pairs.count({4, 6, 6, 7}));
  EXPECT_FALSE(pairs.count({4, 2, 6, 2}));
  EXPECT_FALSE(pairs.count({3, 8, 4, 8}));
}

TEST(CutPairs, AreSortedWithTheSmallerSeedFirst) {
  const Section section = cut(scene_of(overhang()), 0.4);
  ASSERT_GT(section.cut_pairs.size(), 1u);
  for (std::size_t i = 0; i < section.cut_pairs.size(); ++i) {
    EXPECT_LT(section.cut_pairs[i].a, section.cut_pairs[i].b);
    if (i == 0) continue;
    const CutPair &p = section.cut_pairs[i - 1], &q = section.cut_pairs[i];
    EXPECT_TRUE(p.a < q.a || (p.a == q.a && p.b < q.b));
  }
}

TEST(CutPairs, AHeldFaceIsNoAir) {
  SceneDef scene = scene_of(vertical_cut());
  BoundaryDef held;
  held.polyline = {{0, 5}, {10, 5}, {10, 10}};
  scene.boundaries = {held};
  EXPECT_TRUE(cut(scene, 1.0).cut_pairs.empty());
}

}  // namespace
}  // namespace vbgpd::geometry_test
