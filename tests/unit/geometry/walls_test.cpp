#include <gtest/gtest.h>

#include "sections.h"

namespace vbgpd::geometry_test {
namespace {

Polygon box() { return {{0, 0}, {8, 0}, {8, 5}, {0, 5}}; }

TEST(Walls, BoxHasBaseSidesAndCorners) {
  const Section section = cut(scene_of(box()), 1.0);
  EXPECT_EQ(count(section, Hold::kFree), 40);
  EXPECT_EQ(count(section, Hold::kFixed), 3 * 8 + 2 * 3 * 3);  // base and both corners
  EXPECT_EQ(count(section, Hold::kRoller), 2 * 3 * 5);
  EXPECT_EQ(seed_at(section, -3, -3)->hold, Hold::kFixed);
  EXPECT_EQ(seed_at(section, -1, 0)->hold, Hold::kRoller);
  EXPECT_EQ(seed_at(section, -1, 5), nullptr);  // none above the ground
  EXPECT_EQ(seed_at(section, 0, 5), nullptr);
  EXPECT_EQ(seed_at(section, -4, 0), nullptr);
  EXPECT_EQ(seed_at(section, 0, -4), nullptr);
  ASSERT_EQ(section.boundaries.size(), 3u);
  EXPECT_EQ(section.boundaries[seed_at(section, -1, 2)->boundary].side, "left");
  EXPECT_EQ(section.boundaries[seed_at(section, 8, 2)->boundary].side, "right");
  EXPECT_EQ(section.boundaries[seed_at(section, 2, -1)->boundary].side, "base");
}

TEST(Walls, CornerOfTwoRollersIsHeldBothWays) {
  SceneDef scene = scene_of(box());
  for (const char* side : {"base", "left"}) {
    BoundaryDef roller;
    roller.side = side, roller.kind = BoundaryKind::kRoller;
    scene.boundaries.push_back(roller);
  }
  const Section section = cut(scene, 1.0);
  EXPECT_EQ(count(section, Hold::kFixed), 3 * 3);
  EXPECT_EQ(seed_at(section, -1, -1)->hold, Hold::kFixed);
  EXPECT_EQ(seed_at(section, -1, 0)->hold, Hold::kRoller);
  EXPECT_EQ(seed_at(section, 0, -1)->hold, Hold::kRoller);
}

TEST(Walls, BendOfARollerGoesOnSliding) {
  SceneDef scene = scene_of({{0, 1}, {5, 0}, {10, 1}, {10, 8}, {0, 8}});
  BoundaryDef roller;
  roller.polyline = {{0, 1}, {5, 0}, {10, 1}}, roller.kind = BoundaryKind::kRoller;
  scene.boundaries.push_back(roller);
  const Section section = cut(scene, 0.5);
  EXPECT_GT(count(section, Hold::kRoller), 40);
  EXPECT_EQ(count(section, Hold::kFixed), 0);
}

TEST(Walls, NormalsPointOutOfTheSoil) {
  const Section section = cut(scene_of(box()), 1.0);
  EXPECT_EQ(seed_at(section, -1, 2)->normal, Vec2(-1, 0));
  EXPECT_EQ(seed_at(section, 9, 2)->normal, Vec2(1, 0));
  EXPECT_EQ(seed_at(section, 4, -2)->normal, Vec2(0, -1));
}

TEST(Walls, ReachCountsTheRows) {
  for (const int reach : {0, 1, 2, 3}) {
    const Section section = cut(scene_of(box()), 1.0, 1, reach);
    EXPECT_EQ(count(section, Hold::kFixed), reach * 8 + 2 * reach * reach);
    EXPECT_EQ(count(section, Hold::kRoller), 2 * reach * 5);
  }
}

TEST(Walls, SlopeThatEndsInATipHasNoRightWall) {
  const Section section = cut(scene_of(slope()), 1.0);
  EXPECT_EQ(count(section, Hold::kRoller), 3 * 10);
  EXPECT_EQ(count(section, Hold::kFixed), 3 * 32 + 9);
  for (const Seed& seed : section.seeds) EXPECT_LT(seed.ix, 32);
}

TEST(Walls, RollersExtendTheSoilBesideThemAndFixedCellsAreFull) {
  // Ground at 5.3 m: the top row holds 0.3 of a cell and is merged into the one below.
  SceneDef scene = scene_of({{0, 0}, {8, 0}, {8, 5.3}, {0, 5.3}});
  add_layer(scene, "clay", {{0, 0}, {8, 0}, {8, 2}, {0, 2}});
  Lattice lattice;
  lattice.spacing = Vec2(1, 1);
  const Section section = discretise(scene, lattice, 3, 0);
  for (Index k = 1; k <= 3; ++k) {
    EXPECT_NEAR(seed_at(section, -k, 4)->volume, 1.3, 1e-12);
    EXPECT_EQ(seed_at(section, -k, 5), nullptr);
    EXPECT_EQ(seed_at(section, 7 + k, 3)->material, 0);
    EXPECT_EQ(seed_at(section, 7 + k, 1)->material, 1);
    EXPECT_EQ(seed_at(section, 4, -k)->volume, 1);
    EXPECT_EQ(seed_at(section, 4, -k)->material, 1);
  }
}

TEST(Walls, EndLevelWithTheTopSoilCellBesideThem) {
  // Ground rises away from the left end, whose top (3.4 m) lies in a cell that is more than half full.
  Lattice lattice;
  lattice.spacing = Vec2(1, 1);
  const Section section = discretise(scene_of({{0, 0}, {8, 0}, {8, 6}, {0, 3.4}}), lattice, 3, 0);
  ASSERT_EQ(seed_at(section, 0, 3)->hold, Hold::kFree);
  EXPECT_NE(seed_at(section, -1, 3), nullptr);
  EXPECT_EQ(seed_at(section, -1, 4), nullptr);
}

TEST(Walls, SlopingBaseIsBackedByFullThickness) {
  const Section section = cut(scene_of({{0, 3}, {20, 0}, {20, 10}, {0, 10}}), 1.0);
  const double sin = 3 / std::hypot(20.0, 3.0);
  for (const Seed& seed : section.seeds)
    if (seed.hold == Hold::kFixed && seed.ix >= 0 && seed.ix < 20) {
      EXPECT_NEAR(seed.normal.x(), -sin, 1e-12);
      EXPECT_LT(seed.normal.y(), 0);
    }
  for (Index ix = 3; ix < 17; ++ix) {
    int below = 0;
    for (const Seed& seed : section.seeds) below += seed.ix == ix && seed.hold == Hold::kFixed;
    EXPECT_GE(below, 3);
    EXPECT_LE(below, 4);
  }
}

TEST(Walls, HeldPolylineFollowsTheExteriorAroundItsVertices) {
  SceneDef scene = scene_of(box());
  BoundaryDef wall;
  wall.polyline = {{0, 3}, {4, 0}};  // by the shorter way: down the left side to the corner, then along the base
  wall.kind = BoundaryKind::kFixed;
  scene.boundaries = {wall};
  const Section section = cut(scene, 1.0, 1, 2);
  EXPECT_EQ(count(section, Hold::kFixed), 2 * 3 + 2 * 4 + 2 * 2);
  EXPECT_EQ(seed_at(section, -1, 3), nullptr);
  EXPECT_EQ(seed_at(section, 4, -1), nullptr);
  EXPECT_EQ(seed_at(section, -1, 2)->normal, Vec2(-1, 0));
}

TEST(Walls, FixedWinsOverVelocityOverRollerInCorners) {
  SceneDef scene = scene_of(box());
  scene.boundaries.resize(3);
  scene.boundaries[0].side = "left";
  scene.boundaries[0].kind = BoundaryKind::kRoller;
  scene.boundaries[1].side = "base";
  scene.boundaries[1].kind = BoundaryKind::kVelocity;
  scene.boundaries[2].side = "right";
  scene.boundaries[2].kind = BoundaryKind::kFixed;
  const Section section = cut(scene, 1.0);
  EXPECT_EQ(seed_at(section, -2, -2)->hold, Hold::kVelocity);
  EXPECT_EQ(seed_at(section, 9, -2)->hold, Hold::kFixed);
  EXPECT_EQ(seed_at(section, 9, 4)->volume, 1);
}

TEST(Walls, FreeBoundariesHoldNothing) {
  SceneDef scene = scene_of(box());
  scene.boundaries.resize(1);
  scene.boundaries[0].side = "base";
  scene.boundaries[0].kind = BoundaryKind::kFree;
  EXPECT_EQ(cut(scene, 1.0).seeds.size(), 40u);
}

}  // namespace
}  // namespace vbgpd::geometry_test
