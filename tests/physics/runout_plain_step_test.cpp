// The fast step of a run-out equals the plain one, for every instruction set: a heap of disturbed soil whose particles
// fly about, so that neighbours come and go, pairs collide, and most of it yields or comes apart.
#include "physics/runout_plain_step.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

constexpr int kSteps = 20;

struct Case {
  const char* name;
  std::function<void(SceneDef&)> change;
};

BoundaryDef held_by_nothing() {
  BoundaryDef free;
  free.side = "base", free.kind = BoundaryKind::kFree;
  return free;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> list = {
      {"virtual bonds, rough base, smooth wall", [](SceneDef&) {}},
      {"no bonds", [](SceneDef& s) { s.bond = "none"; }},
      {"sph", [](SceneDef& s) { s.bond = "sph"; }},
      {"smooth walls", [](SceneDef& s) { s.boundaries[0].kind = BoundaryKind::kRoller; }},
      {"rough walls", [](SceneDef& s) { s.boundaries[1].kind = BoundaryKind::kFixed; }},
      {"no walls", [](SceneDef& s) { s.boundaries = {held_by_nothing()}; }},
      {"elastic", [](SceneDef& s) { s.materials[0].law = "elastic"; }},
      {"mohr-coulomb with cohesion that grows",
       [](SceneDef& s) {
         s.materials[0].law = "mohr_coulomb", s.materials[0].cohesion = 500;
         s.materials[0].cohesion_gradient = 5000, s.materials[0].cohesion_datum = 0.1;
       }},
      {"two soils",
       [](SceneDef& s) {
         MaterialDef clay = soil("undrained", 2e3, 0);
         clay.name = "clay", clay.unit_weight = 15e3, clay.young_modulus = 0.4e6;
         s.materials.push_back(clay);
         s.layers.push_back({"clay", {{0, 0}, {0.2, 0}, {0.2, 0.05}, {0, 0.03}}});
       }},
  };
  return list;
}

/// Velocities up to a twelfth of the wave speed, stresses of some hundred pascals, some soil that is disturbed and
/// some that has come apart.
void stir(FlowSimulation& s) {
  std::mt19937 random(1);
  const auto any = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  const FlowModel& m = s.model();
  const double fast = 0.08 * m.options.time_step * m.spacing / m.time_step;
  FlowState& state = s.state();
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.particles); ++i) {
    for (std::size_t k = 2; k < 4; ++k) state.motion[4 * i + k] = any(-fast, fast);
    for (std::size_t k = 0; k < 3; ++k) state.stress[4 * i + k] = any(-200, 200);
    state.stress[4 * i + 3] = any(-1500, 0);
    state.plastic_strain[i] = any(0, 0.015), state.gap[i] = std::max(0.0, any(-0.002, 0.002));
  }
  s.state_was_changed();
}

void compare(const SceneDef& scene, const FlowKernels& kernels, const char* name) {
  FlowSimulation fast(LatticeSimulation(scene, {}, best_kernels()), {}, kernels);
  stir(fast);
  PlainRunout plain(fast.model(), fast.state());
  const double searches = fast.get("neighbour_searches");
  fast.step(kSteps, nullptr);
  if (scene.materials[0].law != "elastic") {  // an elastic heap springs back before anything has moved that far
    EXPECT_GT(fast.get("neighbour_searches"), searches) << name;
  }
  for (int k = 0; k < kSteps; ++k) plain.step();
  const FlowState& s = fast.state();
  double speed = 0, stress = 0, gap = 1e-300;
  for (const PlainRunout::Particle& p : plain.particles) {
    speed = std::max(speed, p.v.norm()), gap = std::max(gap, p.gap);
    stress = std::max({stress, p.deviator.cwiseAbs().maxCoeff(), std::fabs(p.mean)});
  }
  double dx = 0, dv = 0, ds = 0, dp = 0, dg = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(fast.model().particles); ++k) {
    const PlainRunout::Particle& p = plain.particles[static_cast<std::size_t>(s.particle[k])];
    const double* const a = s.motion.data() + 4 * k;
    const double* const b = s.stress.data() + 4 * k;
    dx = std::max(dx, (Vec2(a[0], a[1]) - p.x).norm()), dv = std::max(dv, (Vec2(a[2], a[3]) - p.v).norm());
    ds = std::max({ds, std::fabs(b[0] - p.deviator(0, 0)), std::fabs(b[1] - p.deviator(1, 1)),
                   std::fabs(b[2] - p.deviator(0, 1)), std::fabs(b[3] - p.mean)});
    dp = std::max(dp, std::fabs(s.plastic_strain[k] - p.plastic_strain)),
    dg = std::max(dg, std::fabs(s.gap[k] - p.gap));
  }
  constexpr double kSame = 1e-12;
  EXPECT_LT(dx / fast.model().height, kSame) << name << " " << kernels.isa;
  EXPECT_LT(dv / speed, kSame) << name << " " << kernels.isa;
  EXPECT_LT(ds / stress, kSame) << name << " " << kernels.isa;
  EXPECT_LT(dp, kSame) << name << " " << kernels.isa;
  EXPECT_LT(dg / gap, kSame) << name << " " << kernels.isa;
}

TEST(RunoutPlainStep, EqualsTheFastStep) {
  for (const FlowKernels& kernels : all_flow_kernels()) {
    if (!kernels.supported) continue;
    for (const Case& c : cases()) {
      SceneDef scene = bar_column(6);
      c.change(scene);
      compare(scene, kernels, c.name);
    }
  }
}

}  // namespace
}  // namespace vbgpd::test
