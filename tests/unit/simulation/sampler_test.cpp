#include "simulation/sampler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/scenes.h"

namespace vbgpd {
namespace {

std::unique_ptr<Simulation> slope(double spacing) {
  return Simulation::compile(test::slope(test::soil("mohr_coulomb", 10e3, 20), spacing), {});
}

TEST(Sampler, IsExactForLinearFieldsUpToTheFace) {
  const auto s = slope(1);
  const Sampler position(*s, find_field("reference_position"), false);
  for (const Point& p : {Point{0.05, 0.05}, {5, 9.95}, {21.9, 4.9}, {27, 1.2}}) {
    double v[2];
    ASSERT_TRUE(position.at(p.x, p.y, v)) << p.x << ", " << p.y;
    EXPECT_NEAR(v[0], p.x, 1e-9);
    EXPECT_NEAR(v[1], p.y, 1e-9);
  }
}

TEST(Sampler, KnowsWhereThereIsNoSoil) {
  const auto s = slope(1);
  const Sampler position(*s, find_field("position"), true);
  double v[2];
  for (const Point& p : {Point{22.2, 5.1}, {-0.1, 3}, {5, 10.1}, {1e6, -1e6}}) {
    EXPECT_FALSE(position.at(p.x, p.y, v)) << p.x << ", " << p.y;
    EXPECT_TRUE(std::isnan(v[0]) && std::isnan(v[1]));
  }
}

TEST(Sampler, AsksInThePresentShape) {
  const auto s = slope(1);
  RelaxOptions options;
  for (int k = 0; k < 40; ++k) s->relax(10, options);
  const Sampler displacement(*s, find_field("displacement"), true),
      reference(*s, find_field("reference_position"), true);
  double u[2], x[2];
  ASSERT_TRUE(displacement.at(6, 6, u) && reference.at(6, 6, x));
  EXPECT_LT(u[1], -1e-4);
  EXPECT_NEAR(x[0] + u[0], 6, 1e-9);
  EXPECT_NEAR(x[1] + u[1], 6, 1e-9);
}

TEST(DeformedGround, IsTheGroundBeforeAnythingMoves) {
  const auto s = slope(1);
  const auto line = deformed_ground(*s);
  EXPECT_EQ(line.front().x, 0);
  EXPECT_EQ(line.front().y, 10);
  EXPECT_EQ(line.back().x, 32);
  EXPECT_EQ(line.back().y, 0);
  for (std::size_t k = 1; k < line.size(); ++k) EXPECT_GT(line[k].x, line[k - 1].x);
}

}  // namespace
}  // namespace vbgpd
