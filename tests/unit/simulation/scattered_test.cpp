#include "simulation/scattered.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vbgpd {
namespace {

double plane(double x, double y) { return 3 - 2 * x + 0.5 * y; }

/// Nodes without any order, as a triangulation has them.
std::vector<Point> nodes(int count) {
  std::vector<Point> out;
  for (int k = 0; k < count; ++k) out.push_back({std::fmod(k * 0.618034, 1) * 20, std::fmod(k * 0.754878, 1) * 10});
  return out;
}

Scattered of(const std::vector<Point>& places, double (*f)(double, double)) {
  std::vector<double> values;
  for (const Point& p : places) values.push_back(f(p.x, p.y));
  return Scattered(places, values, 1);
}

TEST(Scattered, ReproducesLinearFieldsInsideAndBeyondTheNodes) {
  for (const int count : {9, 50, 3000}) {
    const Scattered field = of(nodes(count), plane);
    for (const Point& p : {Point{10, 5}, {0.1, 9.7}, {-2, -1}, {23, 11}}) {
      double v = 0;
      field.at(p.x, p.y, &v);
      EXPECT_NEAR(v, plane(p.x, p.y), 1e-9) << count << " nodes, at " << p.x << ", " << p.y;
    }
  }
}

TEST(Scattered, GoesThroughItsNodes) {
  const auto places = nodes(200);
  const Scattered field = of(places, [](double x, double y) { return std::sin(x) * y; });
  for (const Point& p : places) {
    double v = 0;
    field.at(p.x, p.y, &v);
    EXPECT_EQ(v, std::sin(p.x) * p.y);
  }
}

TEST(Scattered, ReproducesLinearFieldsOnStretchedMeshes) {
  for (const double wide : {1.0, 5.0, 25.0})
    for (const bool upright : {false, true}) {
      std::vector<Point> places;
      for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 60; ++j) {
          const double a = 0.5 * wide * i, b = 0.5 * j;
          places.push_back(upright ? Point{a, b} : Point{b, a});
        }
      const Scattered field = of(places, plane);
      for (const double at : {0.3, 1.1, 5.7}) {
        double v = 0;
        field.at(at, at + 0.2, &v);
        EXPECT_NEAR(v, plane(at, at + 0.2), 1e-9) << "cells of 0.5 m x " << 0.5 * wide << " m, at " << at;
      }
    }
}

TEST(Scattered, GoesOnAlongALineOfNodesAndKnowsNothingAcross) {
  const Scattered pair({{0, 0}, {1, 0}}, {2, 4}, 1);
  double v = 0;
  for (const double x : {0.5, 0.25, 1.5}) {
    pair.at(x, 3, &v);
    EXPECT_NEAR(v, 2 + 2 * x, 1e-12);
  }
  std::vector<Point> borehole;
  for (int k = 0; k < 700; ++k) borehole.push_back({4 + 0.03 * k, 10 - 0.04 * k});  // inclined
  const Scattered field = of(borehole, plane);
  for (const double off : {0.0, 0.7, -3.0}) {
    field.at(4 + 0.3 + 0.8 * off, 10 - 0.4 + 0.6 * off, &v);
    EXPECT_NEAR(v, plane(4.3, 9.6), 1e-9) << off << " m beside it";
  }
  const Scattered single({{7, 7}}, {5}, 1);
  single.at(-1e6, 1e6, &v);
  EXPECT_EQ(v, 5);
}

TEST(Raster, IsBilinearAndGoesOnLinearlyBeyondItsRim) {
  const Raster raster{0, 0, 10, 5, 2, 2, {plane(0, 0), plane(10, 0), plane(0, 5), plane(10, 5)}};
  for (const Point& p : {Point{3, 2}, {10, 5}, {12, -1}}) EXPECT_NEAR(raster.at(p.x, p.y), plane(p.x, p.y), 1e-12);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(Raster({0, 0, 10, 5, 2, 2, {1, nan, 1, 1}}).at(3, 2)));
}

}  // namespace
}  // namespace vbgpd
