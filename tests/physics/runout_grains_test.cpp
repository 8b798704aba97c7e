// Loose grains of a run-out: what has hardly a neighbour left is no continuum. It has contacts and no stress.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

MaterialDef clod() {
  MaterialDef m = soil("drucker_prager", 5e3, 30);
  m.young_modulus = 20e6;
  return m;
}

/// velocity(x, y) at every particle, by where it started.
template <class F>
void throw_by(Simulation& s, F&& velocity) {
  std::vector<double> v;
  const std::vector<double> x = field(s, "position"), u = field(s, "displacement");
  for (std::size_t i = 0; i < x.size(); i += 2) {
    const Vec2 one = velocity(x[i] - u[i], x[i + 1] - u[i + 1]);
    v.push_back(one.x()), v.push_back(one.y());
  }
  s.write(find_field("velocity"), v);
}

struct Pair {
  double largest_stress = 0, least_distance = 1, momentum = 0, energy_residual = 0, end_speed = 0;
};

/// Two of four particles leave, the others go on at that speed towards each other.
Pair pair_of(const FlowOptions& options, double speed) {
  const auto s = runout(free_body(clod(), 2, 2, 1), 1, options);
  throw_by(*s, [](double, double y) { return Vec2(0, y < 1 ? 0 : 50); });
  s->step(150, nullptr);
  throw_by(*s, [&](double x, double y) { return y < 1 ? Vec2(x < 1 ? speed : -speed, 0) : Vec2(0, 50); });
  Pair p;
  for (int n = 0; n < 1200; ++n) {
    s->step(1, nullptr);
    for (const double stress : field(*s, "stress")) p.largest_stress = std::max(p.largest_stress, std::fabs(stress));
    p.least_distance = std::min(p.least_distance, smallest_distance(*s));
  }
  const std::vector<double> v = field(*s, "velocity");
  for (std::size_t i = 0; i < v.size(); i += 2)
    p.momentum += v[i], p.end_speed = std::max(p.end_speed, std::fabs(v[i]));
  p.energy_residual = s->get("energy_residual");
  return p;
}

FlowOptions small_steps() {
  FlowOptions options;
  options.time_step = 0.1;
  return options;
}

TEST(RunoutGrains, CarryNoStressWhereTwoMeetAlone) {
  const Pair p = pair_of(small_steps(), 1);
  EXPECT_EQ(p.largest_stress, 0);
  EXPECT_LT(p.least_distance, 0.8);  // the guard has parted them
  EXPECT_NEAR(p.momentum, 0, 1e-14);
  EXPECT_LT(p.energy_residual, 0.01);
  FlowOptions continuum = small_steps();
  continuum.loose = 0;
  EXPECT_GT(pair_of(continuum, 1).largest_stress, 1e3);
}

TEST(RunoutGrains, PartWithoutAPull) {
  EXPECT_NEAR(pair_of(small_steps(), -1).end_speed, 1, 1e-12);
  FlowOptions continuum = small_steps();
  continuum.loose = 0;
  EXPECT_LT(pair_of(continuum, -1).end_speed, 0.999);
}

// sand in motion is chaotic: 0 in most runs, 1 in some
TEST(RunoutGrains, StayWithACollapsingColumn) {
  const auto s = runout(bar_column(20));
  load_by_gravity(*s);
  s->advance_to(0.8, [] { return Status::kOk; });
  const std::vector<std::size_t> masses = pieces(field(*s, "position"), 1.6 * s->model().spacing);
  EXPECT_LE(800 - *std::max_element(masses.begin(), masses.end()), 2u);
}

}  // namespace
}  // namespace vbgpd::test
