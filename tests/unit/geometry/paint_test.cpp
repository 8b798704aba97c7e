#include "geometry/paint.h"

#include <gtest/gtest.h>

namespace vbgpd {
namespace {

Vertices rectangle(Real x0, Real y0, Real x1, Real y1) {
  return {Vec2(x0, y0), Vec2(x1, y0), Vec2(x1, y1), Vec2(x0, y1)};
}

TEST(Paint, LaterLayersHideEarlierOnes) {
  const Vertices exterior = rectangle(0, 0, 10, 10), lower = rectangle(0, 0, 10, 6), patch = rectangle(2, 4, 4, 12);
  const Painted painted = paint(exterior, {nullptr, &lower, &patch});
  EXPECT_NEAR(painted.inside[0], 100, 1e-12);
  EXPECT_NEAR(painted.inside[1], 60, 1e-12);
  EXPECT_NEAR(painted.inside[2], 12, 1e-12);
  EXPECT_NEAR(painted.visible[0], 40 - 8, 1e-12);
  EXPECT_NEAR(painted.visible[1], 60 - 4, 1e-12);
  EXPECT_NEAR(painted.visible[2], 12, 1e-12);
  EXPECT_EQ(painted.bare, 0);
}

TEST(Paint, FindsBareSoilAndAPlaceInIt) {
  const Vertices exterior = rectangle(0, 0, 10, 10), left = rectangle(-1, -1, 5, 11);
  const Vertices wedge = {Vec2(5, 0), Vec2(10, 0), Vec2(5, 10)};
  const Painted painted = paint(exterior, {&left, &wedge});
  EXPECT_NEAR(painted.bare, 25, 1e-12);
  EXPECT_TRUE(contains(exterior, painted.bare_place));
  EXPECT_FALSE(contains(left, painted.bare_place));
  EXPECT_FALSE(contains(wedge, painted.bare_place));
}

TEST(Paint, CrossingPolygonsAreExact) {
  const Vertices exterior = {Vec2(0, 0), Vec2(8, 0), Vec2(8, 4), Vec2(4, 1), Vec2(0, 4)};  // concave on top
  const Vertices diamond = {Vec2(4, -2), Vec2(7, 1), Vec2(4, 4), Vec2(1, 1)};
  // Diamond above y = 0 is 18 - 4; the notch |x - 4| < 4 (y - 1) / 3 takes the kite (4, 1), (4 +- 12/7, 16/7), (4, 4).
  EXPECT_NEAR(paint(exterior, {&diamond}).inside[0], 14 - 3.0 * 12 / 7, 1e-12);
}

}  // namespace
}  // namespace vbgpd
