#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vbgpd {
namespace {

using Integer = __int128;

/// The exact sign for coordinates that are integers / 2^50.
int sign_of(const long long (&p)[6]) {
  const Integer d = Integer(p[2] - p[0]) * (p[5] - p[1]) - Integer(p[3] - p[1]) * (p[4] - p[0]);
  return d > 0 ? 1 : (d < 0 ? -1 : 0);
}

TEST(Orientation, HasTheExactSignOfPointsAlmostOnALine) {
  std::mt19937_64 random(7);
  constexpr double kUnit = 0x1p-50;
  int on_line = 0, wrong_when_rounded = 0;
  for (int n = 0; n < 20000; ++n) {
    const long long x = static_cast<long long>(random() >> 16), y = static_cast<long long>(random() >> 16);
    const long long dx = static_cast<long long>(random() >> 40), dy = static_cast<long long>(random() >> 40);
    const long long off = n % 3 - 1;
    const long long p[6] = {x, y, x + 3 * dx, y + 3 * dy, x + 5 * dx + off, y + 5 * dy};
    const Vec2 a(p[0] * kUnit, p[1] * kUnit), b(p[2] * kUnit, p[3] * kUnit), c(p[4] * kUnit, p[5] * kUnit);
    const int expected = sign_of(p);
    ASSERT_EQ(orientation(a, b, c), expected);
    ASSERT_EQ(orientation(b, a, c), -expected);
    ASSERT_EQ(orientation(c, a, b), expected);
    on_line += expected == 0;
    const double rounded =
        a.x() * b.y() - a.y() * b.x() + b.x() * c.y() - b.y() * c.x() + c.x() * a.y() - c.y() * a.x();
    wrong_when_rounded += (rounded > 0) - (rounded < 0) != expected;
  }
  EXPECT_GT(on_line, 5000);
  EXPECT_GT(wrong_when_rounded, 100);  // the test is one that rounding fails
}

TEST(Orientation, KeepsItsSignWhereProductsDifferByManyOrders) {
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {0.5, std::nextafter(0.5, 1)}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {0.5, std::nextafter(0.5, 0)}), -1);
  EXPECT_EQ(orientation({1e-60, 1e-60}, {1, 1}, {0.5, 0.5}), 0);
  EXPECT_EQ(orientation({1e-60, 2e-60}, {1, 1}, {0.5, 0.5}), -1);
}

TEST(Meeting, OfSegments) {
  const Segment diagonal{{0, 0}, {1, 1}};
  EXPECT_FALSE(meeting(diagonal, {{0, 0.1}, {0.9, 1}}).any);
  const Meeting cross = meeting(diagonal, {{0, 1}, {1, 0}});
  EXPECT_TRUE(cross.any && !cross.piece);
  EXPECT_EQ(cross.from, Vec2(0.5, 0.5));
  const Meeting touch = meeting(diagonal, {{0.25, 0.25}, {1, 0}});
  EXPECT_TRUE(touch.any && !touch.piece);
  EXPECT_EQ(touch.from, Vec2(0.25, 0.25));
  const Meeting piece = meeting(diagonal, {{2, 2}, {0.5, 0.5}});
  EXPECT_TRUE(piece.piece);
  EXPECT_EQ(piece.from, Vec2(0.5, 0.5));
  EXPECT_EQ(piece.to, Vec2(1, 1));
  const Meeting end = meeting(diagonal, {{1, 1}, {2, 2}});
  EXPECT_TRUE(end.any && !end.piece);
  EXPECT_FALSE(meeting(diagonal, {{1.5, 1.5}, {2, 2}}).any);
  EXPECT_TRUE(on_segment({0.5, 0.5}, diagonal));
  EXPECT_FALSE(on_segment({0.5, std::nextafter(0.5, 1)}, diagonal));
  EXPECT_FALSE(on_segment({1.5, 1.5}, diagonal));
}

TEST(Simple, KnowsPolygonsThatMeetThemselves) {
  EXPECT_TRUE(is_simple({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(is_simple({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}, {0, 1}}));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));                          // bow tie
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {0, 1}}));                // touches an edge
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {0.5, 0}, {0.5, 1}}));                      // runs back over itself
  EXPECT_FALSE(is_simple({{0, 0}, {0.5, 0.5}, {1, 0}, {1, 1}, {0.5, 0.5}, {0, 1}}));  // a vertex twice
}

}  // namespace
}  // namespace vbgpd
