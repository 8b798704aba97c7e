// Coulomb walls of a run-out: a block stays or slides as the closed form says, corners keep the soil out.
#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

/// An elastic block of 1 m x 0.5 m with nothing but its base under it; angle of friction of the base in degrees.
SceneDef block_on_plane(double friction_angle, double spacing = 0.05) {
  MaterialDef rock = soil("elastic", 0, 0);
  rock.young_modulus = 1e7;
  SceneDef s = block(rock, 1, 0.5, spacing);
  s.boundaries.resize(1);
  s.boundaries[0].friction_angle = friction_angle;
  return s;
}

/// Velocity of the centre of mass.
Vec2 mean_velocity(const FlowSimulation& s) {
  const std::vector<double> v = field(s, "velocity"), m = field(s, "mass");
  Vec2 sum = Vec2::Zero();
  double mass = 0;
  for (std::size_t i = 0; i < m.size(); ++i) sum += m[i] * Vec2(v[2 * i], v[2 * i + 1]), mass += m[i];
  return sum / mass;
}

double degrees_of(double slope) { return std::atan(slope) * 180 / kPi; }

struct Slide {
  double speed, residual, contact, released;
};
/// A block on a plane with body forces kh to the side, let go for so many seconds.
Slide slide(double kh, double kv, double friction, double seconds) {
  SceneDef scene = block_on_plane(degrees_of(friction));
  scene.kh = kh, scene.kv = kv;
  const auto s = runout(scene);
  load_by_gravity(*s, 1e-7);
  s->advance_to(seconds, [] { return Status::kOk; });
  return {mean_velocity(*s).x(), s->get("energy_residual"), s->get("contact_work"), s->get("external_work")};
}

TEST(RunoutFriction, BlockSlidesOnACoulombPlaneAsTheClosedFormSays) {
  const double seconds = 0.5, gravity = 9.81;
  struct {
    double kh, kv, friction;
  } const cases[] = {{0.3, 0, 0.2}, {0.3, 0, 0.1}, {-0.4, 0, 0.25}, {0.3, 0.2, 0.15}, {0.2, 0, 0}};
  for (const auto& c : cases) {
    const Slide slid = slide(c.kh, c.kv, c.friction, seconds);
    const double way = c.kh > 0 ? 1 : -1;
    const double speed = gravity * (c.kh - way * c.friction * (1 + c.kv)) * seconds;
    EXPECT_NEAR(slid.speed / speed, 1, 0.01) << c.kh << " " << c.friction;
    EXPECT_LT(slid.residual, 0.01) << c.kh << " " << c.friction;
    // friction takes its share of the work: mu N over the way, of kh W over the same way
    EXPECT_NEAR(slid.contact / slid.released, way * c.friction * (1 + c.kv) / c.kh, 0.02) << c.kh << " " << c.friction;
  }
}

TEST(RunoutFriction, BlockStaysWhereTheSlopeIsLessThanTheFriction) {
  EXPECT_LT(std::fabs(slide(0.3, 0, 0.33, 0.5).speed), 1e-3 * 9.81 * 0.3 * 0.5);
  EXPECT_GT(slide(0.3, 0, 0.27, 0.5).speed, 0.9 * 9.81 * 0.03 * 0.5);
}

TEST(RunoutFriction, BlockSlidesDownAnInclinedPolyline) {
  MaterialDef rock = soil("elastic", 0, 0);
  rock.young_modulus = 1e7;
  SceneDef scene = block(rock, 1, 0.5, 0.05);
  scene.exterior = {{0, 0.3}, {1, 0}, {1, 0.5}, {0, 0.8}};
  scene.boundaries.resize(1);
  scene.boundaries[0].side.clear(), scene.boundaries[0].polyline = {{0, 0.3}, {1, 0}};
  const double seconds = 0.5, theta = std::atan(0.3), friction = 0.15;
  scene.boundaries[0].friction_angle = degrees_of(friction);
  const auto s = runout(scene);
  load_by_gravity(*s, 1e-7);
  s->advance_to(seconds, [] { return Status::kOk; });
  const Vec2 v = mean_velocity(*s);
  const double expected = 9.81 * (std::sin(theta) - friction * std::cos(theta)) * seconds;
  EXPECT_NEAR((v.x() * std::cos(theta) - v.y() * std::sin(theta)) / expected, 1, 0.01);
  EXPECT_LT(std::fabs(v.x() * std::sin(theta) + v.y() * std::cos(theta)), 0.01 * expected);
  EXPECT_LT(s->get("energy_residual"), 0.01);
}

TEST(RunoutFriction, ReactionOfASlidingBlockIsItsFrictionAndItsWeight) {
  SceneDef scene = block_on_plane(degrees_of(0.2));
  scene.kh = 0.3;
  const auto s = runout(scene);
  load_by_gravity(*s, 1e-7);
  const double weight = 20e3 * 0.5;
  EXPECT_NEAR(s->boundary_reaction(0).y() / weight, 1, 1e-4);
  double x = 0, y = 0;
  constexpr int kLooks = 200;
  for (int k = 0; k < kLooks; ++k) {
    s->step(10, nullptr);
    const Vec2 force = s->boundary_reaction(0);
    x += force.x() / kLooks, y += force.y() / kLooks;
  }
  EXPECT_NEAR(y / weight, 1, 0.01);
  EXPECT_NEAR(x / weight, -0.2, 0.003);
}

TEST(RunoutFriction, HandedOverShearStressIsCarriedOnByTheWall) {
  SceneDef scene = block_on_plane(degrees_of(0.5));
  scene.kh = 0.2;
  LatticeSimulation lattice(scene, {}, best_kernels());
  for (int k = 0; k < 100; ++k)
    if (lattice.relax(100, {}).unbalanced_force_ratio < 1e-7) break;
  lattice.halt();
  const FlowSimulation s(lattice);
  EXPECT_NEAR(s.boundary_reaction(0).x() / (20e3 * 0.5), -0.2, 0.03);
}

/// Sand that slides over a base with a convex and a concave corner; `friction_angle` NaN = rough.
void slide_over_corners(double friction_angle) {
  MaterialDef sand = soil("drucker_prager", 500, 30);
  sand.young_modulus = 5e6;
  SceneDef scene = block(sand, 1, 1, 0.05);
  // down 1:2, steeper down 1:1 (convex), then level (concave); nothing holds the sides
  const Polygon base{{0, 1.5}, {1, 1}, {2, 0}, {3, 0}};
  scene.exterior = base;
  scene.exterior.insert(scene.exterior.end(), {{3, 0.2}, {2.2, 0.2}, {1.4, 1.5}, {0, 2.2}});
  scene.boundaries.resize(1);
  scene.boundaries[0].side.clear(), scene.boundaries[0].polyline = base;
  scene.boundaries[0].friction_angle = friction_angle;
  const auto s = runout(scene);
  load_by_gravity(*s);
  ASSERT_EQ(s->advance_to(1, [] { return Status::kOk; }).status, Status::kOk);
  EXPECT_GT(s->get("max_displacement"), 0.3);
  EXPECT_LT(s->get("energy_residual"), 0.01);
  const std::vector<double> x = field(*s, "position");
  for (std::size_t i = 0; i < x.size() / 2; ++i) {
    const double at = x[2 * i], y = x[2 * i + 1];
    const double ground = at < 1 ? 1.5 - at / 2 : std::max(0.0, 2 - at);  // goes on straight at both ends
    EXPECT_GT(y, ground - 0.25 * 0.05) << at;  // the push of a wall is a spring: it gives way by less than that
  }
}

TEST(RunoutFriction, ConvexAndConcaveCornersOfACoulombBaseKeepTheSoilOut) { slide_over_corners(15); }
TEST(RunoutFriction, ConvexAndConcaveCornersOfARoughBaseKeepTheSoilOut) { slide_over_corners(std::nan("")); }

TEST(RunoutFriction, ThreadsAndARestoreDoNotChangeTheBitsOfASlidingBlock) {
  SceneDef scene = block_on_plane(degrees_of(0.1), 0.025);
  scene.kh = 0.3;
  std::uint64_t hash = 0;
  for (const int threads : {1, 3}) {
    const auto s = runout(scene, threads);
    s->step(300, nullptr);
    const StateImage middle = s->image();
    s->step(300, nullptr);
    if (threads == 1) hash = s->state_hash();
    EXPECT_EQ(s->state_hash(), hash) << threads;
    const auto again = Simulation::restored(scene, {}, middle);
    again->step(300, nullptr);
    EXPECT_EQ(again->state_hash(), hash) << threads;
  }
}

}  // namespace
}  // namespace vbgpd::test
