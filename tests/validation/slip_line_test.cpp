// The slip surface as a line: one slide where there are two, and out of level ground no flatter than soil comes out of
// it.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/solve.h"

namespace vbgpd {
namespace {

/// Friction and a little cohesion on 5 m of the same; 9 m high.
SceneDef of_one_soil(Polygon exterior, double dilatancy_angle) {
  SceneDef s;
  MaterialDef soil;
  soil.name = "soil", soil.law = "mohr_coulomb", soil.unit_weight = 20e3, soil.cohesion = 8e3;
  soil.friction_angle = 25, soil.dilatancy_angle = dilatancy_angle;
  s.materials = {soil};
  s.exterior = std::move(exterior);
  s.layers = {{"soil", {}}};
  s.spacing = 0.5;
  return s;
}

TEST(SlipLine, OfADamThatFailsOnBothFacesIsOneSlide) {
  const Real center = 38;
  const JobResult dam =
      solved(of_one_soil({{0, -5}, {76, -5}, {76, 0}, {58, 0}, {40, 9}, {36, 9}, {18, 0}, {0, 0}}, 0), 1);
  const JobResult half = solved(of_one_soil({{0, -5}, {76, -5}, {76, 9}, {36, 9}, {18, 0}, {0, 0}}, 0), 1);
  EXPECT_NE(dam.reason.find("both sides"), std::string::npos) << dam.reason;
  EXPECT_EQ(half.reason.find("both sides"), std::string::npos) << half.reason;
  EXPECT_NEAR(dam.sliding_area, half.sliding_area, 0.2 * half.sliding_area);
  ASSERT_FALSE(dam.slip_surface.empty());
  EXPECT_LT(dam.slip_surface.back().x, center);
  EXPECT_NEAR(dam.slip_surface.back().y, 9, 1e-9);  // comes out at the crest
}

TEST(SlipLine, OfAFootingIsOneMechanism) {
  SceneDef s = of_one_soil({{0, 0}, {32, 0}, {32, 12}, {0, 12}}, 0);
  s.materials[0].law = "undrained", s.materials[0].cohesion = 20e3, s.materials[0].friction_angle = 0;
  s.loads = {{14, 18, 80e3, 80e3}};
  const JobResult result = solved(s, 1);
  EXPECT_EQ(result.reason.find("both sides"), std::string::npos) << result.reason;
  ASSERT_FALSE(result.slip_surface.empty());
  EXPECT_LT(result.slip_surface.front().x, 14);
  EXPECT_GT(result.slip_surface.back().x, 18);
}

TEST(SlipLine, ComesOutOfLevelGroundAtAnAngle) {
  const JobResult result = solved(of_one_soil({{0, -5}, {50, -5}, {50, 0}, {30, 0}, {12, 9}, {0, 9}}, 25), 1);
  const std::vector<Point>& line = result.slip_surface;
  ASSERT_GT(line.size(), 2u);
  const Point end = line.back(), before = line[line.size() - 2];
  EXPECT_NEAR(end.y, 0, 1e-9);
  EXPECT_GT((end.y - before.y) / (end.x - before.x), 0.4);  // atan 0.4 = 22 degrees
  EXPECT_LT(end.x - 30, 0.2 * 9);                           // close to the toe, where the band meets the ground
}

}  // namespace
}  // namespace vbgpd
