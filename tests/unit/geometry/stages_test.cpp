// A section with layers switched off is the section drawn without them.
#include "geometry/stages.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "sections.h"

namespace vbgpd::geometry_test {
namespace {

/// A slope with a berm on its toe that is layer 1.
SceneDef with_berm() {
  SceneDef scene = scene_of({{0, 0}, {40, 0}, {40, 10}, {30, 10}, {30, 6}, {20, 6}, {10, 16}, {0, 16}});
  add_layer(scene, "fill", {{30, 6}, {40, 6}, {40, 10}, {30, 10}});
  return scene;
}
SceneDef without_berm() { return scene_of({{0, 0}, {40, 0}, {40, 6}, {20, 6}, {10, 16}, {0, 16}}); }

using Cell = std::tuple<Index, Index, double, int>;
std::set<Cell> cells(const Section& section) {
  std::set<Cell> all;
  for (const Seed& s : section.seeds)
    if (s.active) all.insert({s.ix, s.iy, s.volume, static_cast<int>(s.hold)});
  return all;
}

void expect_same(const std::vector<Point>& a, const std::vector<Point>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_NEAR(a[k].x, b[k].x, 1e-9);
    EXPECT_NEAR(a[k].y, b[k].y, 1e-9);
  }
}

TEST(Stages, WithoutALayerAreTheSectionDrawnWithoutIt) {
  const SceneDef scene = with_berm();
  Section dug = cut(scene, 1, 2);
  const Section drawn = cut(without_berm(), 1, 2);
  ASSERT_EQ(dug.lattice.spacing, drawn.lattice.spacing);
  keep_layers(scene, {true, false}, dug);
  EXPECT_EQ(cells(dug), cells(drawn));
  EXPECT_EQ(cut_cells(dug), cut_cells(drawn));
  expect_same(dug.ground, drawn.ground);
  EXPECT_NEAR(dug.area, drawn.area, 1e-9);
  EXPECT_NEAR(dug.height, drawn.height, 1e-9);
}

TEST(Stages, WithAllLayersAreTheSectionAsItWas) {
  const SceneDef scene = with_berm();
  const Section before = cut(scene, 0.7, 1);
  Section after = before;
  keep_layers(scene, {true, false}, after);
  EXPECT_LT(cells(after).size(), cells(before).size());
  keep_layers(scene, {true, true}, after);
  EXPECT_EQ(cells(after), cells(before));
  EXPECT_EQ(cut_cells(after), cut_cells(before));
  expect_same(after.ground, before.ground);
  EXPECT_EQ(after.area, before.area);
  EXPECT_EQ(after.height, before.height);
}

TEST(Stages, CutPairsAcrossATrench) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}});
  add_layer(scene, "soil", {{9, 4}, {10, 4}, {10, 10}, {9, 10}});
  Section section = cut(scene, 1, 1);
  EXPECT_TRUE(section.cut_pairs.empty());
  keep_layers(scene, {true, false}, section);
  EXPECT_TRUE(cut_cells(section).count({8, 7, 10, 7}));  // two cells on either side of the trench
  EXPECT_FALSE(cut_cells(section).count({8, 2, 10, 2}));
}

TEST(Stages, FollowInclinedLayersExactly) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}});
  add_layer(scene, "soil", {{5, 10}, {12, 3}, {25, 3}, {25, 12}, {5, 12}});
  Section section = cut(scene, 1, 1);
  keep_layers(scene, {true, false}, section);
  expect_same(section.ground, {{0, 10}, {5, 10}, {12, 3}, {20, 3}});
  EXPECT_NEAR(section.height, 7, 1e-9);
  // seven cells are half and half: they belong to the later layer
  EXPECT_NEAR(section.area, 200 - 7 * 8 - 7 * 7 / 2.0 - 7 * 0.5, 1e-9);
}

TEST(Stages, LeaveABareFloorWhereAllSoilIsGone) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}});
  add_layer(scene, "soil", {{12, -1}, {21, -1}, {21, 11}, {12, 11}});
  Section section = cut(scene, 1, 1);
  keep_layers(scene, {true, false}, section);
  expect_same(section.ground, {{0, 10}, {12, 10}, {12, 0}, {20, 0}});
  EXPECT_NEAR(section.area, 120, 1e-9);
}

TEST(Stages, DoNotBringBackWhatWasPaintedOver) {
  SceneDef scene = scene_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}});
  add_layer(scene, "soil", {{0, 5}, {20, 5}, {20, 10}, {0, 10}});
  add_layer(scene, "soil", {{0, 6}, {20, 6}, {20, 10}, {0, 10}});
  Section section = cut(scene, 1, 1);
  keep_layers(scene, {true, true, false}, section);
  EXPECT_NEAR(section.area, 120, 1e-9);
}

TEST(Stages, RefuseToLeaveNothing) {
  const SceneDef scene = with_berm();
  Section section = cut(scene, 1, 1);
  const auto before = cells(section);
  EXPECT_THROW(keep_layers(scene, {false, false}, section), Error);
  EXPECT_EQ(cells(section), before);
}

}  // namespace
}  // namespace vbgpd::geometry_test
