// Rigid motion makes no stress; a free elastic body keeps its shape, energy and momenta.
#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

MaterialDef rubber() {
  MaterialDef m = soil("elastic", 0, 0);
  m.unit_weight = 1000 * 9.81, m.young_modulus = 1e6;
  return m;
}

TEST(RunoutMotion, PrescribedTurnOnlyTurnsTheStress) {
  const auto s = runout(free_body(rubber(), 1, 0.5, 0.1));
  FlowState& state = s->state();
  const std::size_t n = state.gap.size();
  const double xx = 2e4, yy = -1e4, xy = 0.5e4, mean = 0.3e4, young_modulus = 1e6;
  for (std::size_t i = 0; i < n; ++i)
    state.stress[4 * i] = xx, state.stress[4 * i + 1] = yy, state.stress[4 * i + 2] = xy,
                     state.stress[4 * i + 3] = mean;
  const int steps = 4000;
  const double angle = 20.0 / steps, dt = s->get("time_step");
  double worst = 0;
  for (int k = 0; k < steps; ++k) {
    // where the particles are and how they came there when the step looks at them: a rigid turn
    const double c = std::cos(k * angle), d = std::sin(k * angle);
    const double e = std::cos((k - 1) * angle), f = std::sin((k - 1) * angle);
    for (std::size_t i = 0; i < n; ++i) {
      const auto id = static_cast<std::size_t>(state.particle[i]);
      const double x = s->model().reference_x[id], y = s->model().reference_y[id];
      double* const m = state.motion.data() + 4 * i;
      m[0] = c * x - d * y, m[1] = d * x + c * y;
      m[2] = (m[0] - e * x + f * y) / dt, m[3] = (m[1] - f * x - e * y) / dt;
    }
    ASSERT_EQ(s->step(1, nullptr).status, Status::kOk);
    const double turned = 2 * (k + 1) * angle, half = (xx - yy) / 2;
    const double expected = (xx + yy) / 2 + half * std::cos(turned) - xy * std::sin(turned);
    for (std::size_t i = 0; i < n; ++i) {
      worst = std::max(worst, std::fabs(state.stress[4 * i] - expected));
      worst = std::max(worst, std::fabs(state.stress[4 * i + 3] - mean));
    }
  }
  EXPECT_LT(worst, 1e-11 * young_modulus);
}

TEST(RunoutMotion, FreeFlightMakesNoStressAtAll) {
  const auto s = runout(free_body(rubber(), 1, 0.5, 0.1));
  FlowState& state = s->state();
  for (std::size_t i = 0; i < state.gap.size(); ++i) state.motion[4 * i + 2] = 3, state.motion[4 * i + 3] = -2;
  s->step(500, nullptr);
  for (const double stress : field(*s, "stress")) ASSERT_LT(std::fabs(stress), 1e-12 * 1e6);
}

struct Momenta {
  double x = 0, y = 0, angular = 0, scale = 0;
};
Momenta momenta(const FlowSimulation& s) {
  const std::vector<double> x = field(s, "position"), v = field(s, "velocity"), m = field(s, "mass");
  Momenta sum;
  for (std::size_t i = 0; i < m.size(); ++i) {
    sum.x += m[i] * v[2 * i], sum.y += m[i] * v[2 * i + 1];
    sum.angular += m[i] * (x[2 * i] * v[2 * i + 1] - x[2 * i + 1] * v[2 * i]);
    sum.scale += m[i] * std::hypot(v[2 * i], v[2 * i + 1]);
  }
  return sum;
}

TEST(RunoutMotion, TurningBarKeepsLengthEnergyAndMomenta) {
  FlowOptions options;
  options.viscosity = 0;
  const auto s = runout(free_body(rubber(), 2, 0.4, 0.1), 1, options);
  FlowState& state = s->state();
  const std::size_t n = state.gap.size();
  const double wave = std::sqrt(1e6 * 1.346153846 / 1000), spin = 0.04 * wave / 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    double* const m = state.motion.data() + 4 * i;
    m[2] = -spin * (m[1] - 0.2), m[3] = spin * (m[0] - 1.0);
  }
  const auto ends = [&](std::vector<double> x) {
    double length = 0;
    for (std::size_t i = 0; i < x.size(); i += 2)
      for (std::size_t j = 0; j < i; j += 2) length = std::max(length, std::hypot(x[i] - x[j], x[i + 1] - x[j + 1]));
    return length;
  };
  const double length = ends(field(*s, "position")), energy = s->get("kinetic_energy");
  const Momenta before = momenta(*s);
  const auto steps = static_cast<std::int64_t>(2 * kPi / spin / s->get("time_step"));
  ASSERT_EQ(s->step(steps, nullptr).status, Status::kOk);
  const Momenta after = momenta(*s);
  EXPECT_NEAR(ends(field(*s, "position")) / length, 1, 0.002);
  EXPECT_NEAR((s->get("kinetic_energy") + s->elastic_energy()) / energy, 1, 0.005);
  EXPECT_NEAR(after.angular / before.angular, 1, 1e-3);
  EXPECT_LT(std::hypot(after.x - before.x, after.y - before.y), 1e-12 * before.scale);
}

}  // namespace
}  // namespace vbgpd::test
