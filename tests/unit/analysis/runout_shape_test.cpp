// Which toe a run-out is measured from, and how far beyond it the front is.
#include "analysis/runout_shape.h"

#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

/// The soil above an elevation set `way` off to the side, all of it.
RunoutShape pushed(std::vector<Point> exterior, double above, double way) {
  SceneDef scene = slope(soil("mohr_coulomb", 10e3, 20), 1);
  scene.exterior = std::move(exterior);
  const auto s = runout(scene);
  const std::vector<double> x = field(*s, "position");
  FlowState& state = s->state();
  for (std::size_t i = 0; i < x.size() / 2; ++i)
    if (s->model().reference_y[static_cast<std::size_t>(state.particle[i])] > above) state.motion[4 * i] += way;
  return runout_shape(*s);
}

TEST(RunoutShape, OfAForegroundThatFallsAMillimetreIsThatOfAFlatOne) {
  const double flat = pushed({{0, 0}, {50, 0}, {50, 5}, {32, 5}, {12, 15}, {0, 15}}, 5, 3).runout_distance;
  EXPECT_NEAR(flat, 2, 0.1);  // the lowest row above the foreground ends a metre behind the toe
  EXPECT_NEAR(pushed({{0, 0}, {50, 0}, {50, 4.999}, {32, 5}, {12, 15}, {0, 15}}, 5, 3).runout_distance, flat, 1);
}

TEST(RunoutShape, IsMeasuredOnTheSideWhereTheFrontIs) {
  const std::vector<Point> bank = {{0, 0}, {90, 0}, {90, 5}, {55, 5}, {45, 15}, {35, 15}, {13, 4}, {0, 4}};
  EXPECT_NEAR(pushed(bank, 5.5, 4).runout_distance, 3.5, 1);  // the lowest row above the ground is half a metre back
  EXPECT_NEAR(pushed(bank, 4.5, -4).runout_distance, 3, 1.5);
}

TEST(RunoutShape, BeginsAtTheFootOfAFreeFace) {
  EXPECT_NEAR(pushed({{0, 0}, {5, 0}, {5, 10}, {0, 10}}, 0, 2).runout_distance, 2, 0.1);
}

}  // namespace
}  // namespace vbgpd::test
