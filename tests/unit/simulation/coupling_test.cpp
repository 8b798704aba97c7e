// What is set from outside: pore pressure as a force, other grids, images.
#include <gtest/gtest.h>

#include <cmath>

#include "physics/scenes.h"
#include "simulation/build_model.h"
#include "simulation/outside.h"
#include "simulation/take_over.h"

namespace vbgpd {
namespace {

std::vector<double> read(const Simulation& s, const char* field) {
  std::vector<double> rows;
  s.read(find_field(field), rows);
  return rows;
}

/// p = a + b . x at every particle.
std::vector<double> linear_pressure(const Simulation& s, double a, double bx, double by) {
  const auto xy = read(s, "reference_position");
  std::vector<double> p(xy.size() / 2);
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = a + bx * xy[2 * k] + by * xy[2 * k + 1];
  return p;
}

struct PoreForce : testing::TestWithParam<const char*> {
  SceneDef scene = [this] {
    SceneDef s = test::block(test::soil("elastic", 0, 0), 10, 10, 1);
    s.bond = GetParam();
    return s;
  }();
};

TEST_P(PoreForce, IsMinusTheGradientTimesTheVolumeInside) {
  const Section section = discretise(scene, fit_lattice(scene, 1, 1), support_reach(scene), 0);
  Model m = build_model(scene, section, 4);
  Array pressure;
  pressure.allocate(static_cast<std::size_t>(m.storage), 0);
  const auto center = [&](std::size_t i) {
    const Seed& seed = section.seeds[static_cast<std::size_t>(m.seed_of[i])];
    return section.lattice.center(seed.ix, seed.iy);
  };
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (m.seed_of[i] >= 0) pressure[i] = 5e3 + 1e3 * center(i).x() - 10e3 * center(i).y();
  m.force_x.fill_zero(), m.force_y.fill_zero();
  add_pore_force(pressure, m);
  int inside = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (m.seed_of[i] < 0) continue;
    const Vec2 x = center(i);
    // some supports from the free surface and from where the walls end: what ends there is felt less and less
    if (x.y() > 4 || x.y() < 2 || x.x() < 2 || x.x() > 8) continue;
    ++inside;
    EXPECT_NEAR(m.force_x[i], -1e3 * m.volume[i], 1e-5 * 10e3);
    EXPECT_NEAR(m.force_y[i], 10e3 * m.volume[i], 1e-5 * 10e3);
  }
  EXPECT_GT(inside, 10);
}

TEST_P(PoreForce, SumsUpToNothing) {
  const Section section = discretise(scene, fit_lattice(scene, 1, 1), support_reach(scene), 0);
  Model m = build_model(scene, section, 4);
  Array pressure;
  pressure.allocate(static_cast<std::size_t>(m.storage), 0);
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (m.seed_of[i] >= 0) pressure[i] = 1e4 * std::sin(static_cast<double>(i));
  m.force_x.fill_zero(), m.force_y.fill_zero();
  add_pore_force(pressure, m);
  double x = 0, y = 0, largest = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    x += m.force_x[i], y += m.force_y[i];
    largest = std::max(largest, std::fabs(m.force_x[i]));
  }
  EXPECT_GT(largest, 1e2);
  EXPECT_NEAR(x, 0, 1e-9 * largest);
  EXPECT_NEAR(y, 0, 1e-9 * largest);
}

INSTANTIATE_TEST_SUITE_P(Bonds, PoreForce, testing::Values("virtual_bond", "none"),
                         [](const auto& info) { return std::string(info.param); });

TEST(TakeOver, KeepsLinearPressuresAndTheSumOfForces) {
  const SceneDef scene = test::slope(test::soil("mohr_coulomb", 10e3, 20), 1);
  CompileOptions coarse;
  coarse.coarsening = 2;
  const auto fine = Simulation::compile(scene, {}), other = Simulation::compile(scene, coarse);
  fine->write(find_field("pore_pressure"), linear_pressure(*fine, 9e4, 0, -1e4));
  std::vector<double> force(static_cast<std::size_t>(2 * fine->particle_count()), 0);
  force[20] = 300, force[21] = -700, force[41] = -50;
  fine->write(find_field("external_force"), force);
  fine->set("kh", 0.1);
  take_over(*fine, *other);
  const auto expected = linear_pressure(*other, 9e4, 0, -1e4), got = read(*other, "pore_pressure");
  for (std::size_t k = 0; k < got.size(); ++k) EXPECT_NEAR(got[k], expected[k], 1e-6);
  const auto moved = read(*other, "external_force");
  double x = 0, y = 0;
  for (std::size_t k = 0; k < moved.size(); k += 2) x += moved[k], y += moved[k + 1];
  EXPECT_NEAR(x, 300, 1e-9);
  EXPECT_NEAR(y, -750, 1e-9);
  EXPECT_EQ(other->get("kh"), 0.1);
}

TEST(Image, OfAnotherSectionIsRefusedAndChangesNothing) {
  const auto a = Simulation::compile(test::slope(test::soil("mohr_coulomb", 10e3, 20), 1), {});
  const auto b = Simulation::compile(test::block(test::soil("mohr_coulomb", 10e3, 20), 10, 10, 1), {});
  b->step(5, nullptr);
  const auto before = b->state_hash();
  EXPECT_THROW(b->restore_image(a->image()), Error);
  StateImage image = b->image();
  image.rows[0].values[3] += 1e-3;  // another state than the hash says
  EXPECT_THROW(b->restore_image(image), Error);
  image = b->image();
  image.plastic.push_back({0, static_cast<std::int32_t>(b->particle_count()) - 1, 1e-3, 0, 0});
  EXPECT_THROW(b->restore_image(image), Error);
  image = b->image();
  image.numbers.erase(image.numbers.begin());
  EXPECT_THROW(b->restore_image(image), Error);
  EXPECT_EQ(b->state_hash(), before);
  EXPECT_NO_THROW(b->restore_image(b->image()));
  EXPECT_EQ(b->state_hash(), before);
}

TEST(Image, BringsBackAModelThatGoesOnAlike) {
  const SceneDef scene = test::slope(test::soil("drucker_prager", 2e3, 20, 10), 1);
  const auto a = Simulation::compile(scene, {}), b = Simulation::compile(scene, {});
  a->write(find_field("pore_pressure"), linear_pressure(*a, 3e4, 0, -5e3));
  a->step(300, nullptr);
  ASSERT_GT(a->get("plastic_bonds"), 0);
  b->restore_image(a->image());
  EXPECT_EQ(a->state_hash(), b->state_hash());
  a->step(50, nullptr), b->step(50, nullptr);
  EXPECT_EQ(a->state_hash(), b->state_hash());
  EXPECT_EQ(a->get("external_work"), b->get("external_work"));
}

}  // namespace
}  // namespace vbgpd
