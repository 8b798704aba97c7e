// What walls do to the soil: prescribed motion, rollers along an axis and on an incline.
#include <gtest/gtest.h>

#include <cmath>

#include "physics/scenes.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {
namespace {

/// Mean of a particle field component over the soil particles for which `use(x, y)` holds.
template <class Use>
double mean(const Simulation& s, const char* field, std::size_t component, Use&& use) {
  std::vector<double> values, position;
  s.read(find_field(field), values);
  s.read(find_field("reference_position"), position);
  std::vector<std::int64_t> boundary;
  s.read(find_field("boundary"), boundary);
  const std::size_t components = values.size() / boundary.size();
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < boundary.size(); ++i)
    if (boundary[i] < 0 && use(position[2 * i], position[2 * i + 1]))
      sum += values[components * i + component], count += 1;
  return sum / count;
}

SceneDef pressed_block(double velocity) {
  SceneDef scene = test::block(test::soil("elastic", 0, 0), 10, 5, 0.5);
  scene.boundaries[0].kind = BoundaryKind::kRoller;
  scene.boundaries[2].kind = BoundaryKind::kVelocity;
  scene.boundaries[2].vx = velocity;
  return scene;
}

TEST(MovingWall, PressesTheSoilByThePlaneStrainModulus) {
  const double velocity = -1e-4;
  const auto still = Simulation::compile(pressed_block(0), {}), moving = Simulation::compile(pressed_block(velocity), {});
  for (Simulation* s : {still.get(), moving.get()}) {
    s->set("damping", 0.8);
    ASSERT_EQ(s->step(6000, nullptr).status, Status::kOk);
  }
  const auto inside = [](double x, double y) { return x > 3 && x < 7 && y > 1 && y < 4; };
  const double stress = mean(*moving, "stress", 0, inside) - mean(*still, "stress", 0, inside);
  const double strain = velocity * moving->get("time") / 10;
  EXPECT_NEAR(stress, 1e8 / (1 - 0.09) * strain, 0.1 * std::fabs(stress));  // E / (1 - nu^2), free at the top; walls act half a spacing off
  std::vector<double> displacement;
  std::vector<std::int64_t> boundary;
  moving->read(find_field("displacement"), displacement);
  moving->read(find_field("boundary"), boundary);
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    if (boundary[i] == 2) {
      EXPECT_NEAR(displacement[2 * i], velocity * moving->get("time"), 1e-9);
    }
  }
}

TEST(Roller, AtTheSideCarriesNothingOfALoadThatReachesIt) {
  constexpr double kLoad = 1e5, kLow = 3.25, kHigh = 7.25;
  SceneDef scene = test::block(test::soil("elastic", 0, 0), 5, 10, 0.5);
  scene.materials[0].unit_weight = 0;
  scene.loads = {{0, 5, kLoad, kLoad}};
  const auto s = Simulation::compile(scene, {});
  for (int n = 0; n < 500 && s->relax(10, {}).unbalanced_force_ratio > 1e-9; ++n) {
  }
  const double oedometric = 1e8 * 0.7 / (1.3 * 0.4);
  for (double column = 0.25; column < 5; column += 0.5) {
    const auto settlement = [&](double level) {
      return -mean(*s, "displacement", 1, [&](double x, double y) {
        return std::fabs(x - column) < 1e-6 && std::fabs(y - level) < 1e-6;
      });
    };
    const double exact = kLoad / oedometric * (kHigh - kLow);
    EXPECT_NEAR(settlement(kHigh) - settlement(kLow), exact, 3e-3 * exact) << column;  // 20 % less without the images
  }
}

TEST(Roller, OnAnInclineLetsABlockSlideWithoutFriction) {
  SceneDef scene = test::block(test::soil("elastic", 0, 0), 20, 5, 0.5);
  scene.exterior = {{0, 0}, {20, 5}, {20, 10}, {0, 5}};
  BoundaryDef incline;
  incline.polyline = {{0, 0}, {20, 5}};
  incline.kind = BoundaryKind::kRoller;
  scene.boundaries = {incline};
  const auto s = Simulation::compile(scene, {});
  ASSERT_EQ(s->step(3000, nullptr).status, Status::kOk);
  const double slope = std::atan2(5.0, 20.0), c = std::cos(slope), n = std::sin(slope);
  const auto all = [](double, double) { return true; };
  const double vx = mean(*s, "velocity", 0, all), vy = mean(*s, "velocity", 1, all);
  const double expected = -9.81 * n * s->get("time");  // v = g sin(beta) t, downhill is to the left
  EXPECT_NEAR(vx * c + vy * n, expected, 0.02 * std::fabs(expected));
  EXPECT_NEAR(-vx * n + vy * c, 0, 0.05 * std::fabs(expected));
}

}  // namespace
}  // namespace vbgpd
