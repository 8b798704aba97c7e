// Which toe a run-out is measured from, and how far beyond it the front is.
#include "analysis/runout_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

/// The soil above an elevation set `way` off to the side, all of it.
RunoutShape pushed(std::vector<Point> exterior, double above, double way, bool walled = false) {
  SceneDef scene = slope(soil("mohr_coulomb", 10e3, 20), 1);
  scene.exterior = std::move(exterior);
  if (walled) scene.boundaries.clear();  // the usual ones: base and both sides
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

TEST(RunoutShape, GroundThatIsPushedAlongBeforeTheToeIsNoFront) {
  // everything moves by 2 m, the foreground of 18 m too: what came from behind the toe is 2 m beyond it
  EXPECT_NEAR(pushed({{0, 0}, {50, 0}, {50, 5}, {32, 5}, {12, 15}, {0, 15}}, -1, 2).runout_distance, 2, 1);
}

TEST(RunoutShape, BeginsAtTheFootOfAFreeFace) {
  EXPECT_NEAR(pushed({{0, 0}, {5, 0}, {5, 10}, {0, 10}}, 0, 2).runout_distance, 2, 0.1);
}

TEST(RunoutShape, SaysWhenTheFrontHasComeToTheEndOfTheSection) {
  const std::vector<Point> short_one = {{0, 0}, {36, 0}, {36, 5}, {32, 5}, {12, 15}, {0, 15}};
  EXPECT_TRUE(std::isnan(pushed(short_one, 5, 2, true).stopped_at));
  EXPECT_EQ(pushed(short_one, 5, 4.5, true).stopped_at, 36);
  EXPECT_TRUE(std::isnan(pushed(short_one, 5, 4.5).stopped_at));  // no wall there: the soil goes on
}

TEST(RunoutShape, GroundOfStretchedSoilHasNoPits) {
  const auto s = runout(slope(soil("mohr_coulomb", 10e3, 20), 1));
  FlowState& state = s->state();
  for (std::size_t i = 0; i < static_cast<std::size_t>(s->particle_count()); ++i) state.motion[4 * i] *= 1.45;
  const std::vector<Point> ground = ground_surface(*s);
  ASSERT_GT(ground.size(), 20u);
  for (std::size_t k = 1; k + 1 < ground.size(); ++k)
    EXPECT_GE(ground[k].y, std::min(ground[k - 1].y, ground[k + 1].y)) << "at x = " << ground[k].x;
}

}  // namespace
}  // namespace vbgpd::test
