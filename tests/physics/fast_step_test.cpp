// The fast step equals the plain one: every law, bond law, kernel and instruction set, with walls, layers, loads and
// cut bonds.
#include <gtest/gtest.h>

#include <functional>

#include "physics/reference_step.h"
#include "physics/scenes.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {
namespace {

struct Variant {
  const char* name;
  std::function<void(SceneDef&)> change;
};

SceneDef plain_scene() {
  SceneDef s = test::slope(test::soil("drucker_prager", 2e3, 20), 2.0);
  s.exterior = {{0, 0}, {30, 0}, {30, 4}, {20, 4}, {12, 10}, {0, 10}};
  BoundaryDef right = s.boundaries[1];
  right.side = "right";
  s.boundaries.push_back(right);
  return s;
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> list = {
      {"drucker-prager", [](SceneDef&) {}},
      {"dilatant", [](SceneDef& s) { s.materials[0].dilatancy_angle = 20; }},
      {"mohr-coulomb", [](SceneDef& s) { s.materials[0].law = "mohr_coulomb"; }},
      {"dilatant mohr-coulomb with cut-off",
       [](SceneDef& s) {
         s.materials[0].law = "mohr_coulomb", s.materials[0].dilatancy_angle = 10, s.materials[0].tension_cutoff = 500;
       }},
      {"undrained with gradient",
       [](SceneDef& s) {
         s.materials[0] = test::soil("undrained", 8e3, 0);
         s.materials[0].cohesion_gradient = 500, s.materials[0].cohesion_datum = 8;
       }},
      {"undrained with gradient on rock",
       [](SceneDef& s) {
         s.materials[0] = test::soil("undrained", 8e3, 0);
         s.materials[0].cohesion_gradient = 500, s.materials[0].cohesion_datum = 8;
         MaterialDef rock = test::soil("elastic", 0, 0);
         rock.name = "rock";
         s.materials.push_back(rock);
         s.layers.push_back({"rock", {{0, 0}, {30, 0}, {30, 3}, {0, 2}}});
       }},
      {"elastic", [](SceneDef& s) { s.materials[0].law = "elastic"; }},
      {"no bonds", [](SceneDef& s) { s.bond = "none"; }},
      {"no bonds, mohr-coulomb", [](SceneDef& s) { s.bond = "none", s.materials[0].law = "mohr_coulomb"; }},
      {"cubic spline", [](SceneDef& s) { s.kernel = "cubic_spline"; }},
      {"two laws, stiff layer",
       [](SceneDef& s) {
         MaterialDef clay = test::soil("undrained", 6e3, 0);
         clay.name = "clay", clay.young_modulus = 5e8;
         s.materials[0].law = "mohr_coulomb";
         s.materials.push_back(clay);
         s.layers.push_back({"clay", {{0, 0}, {30, 0}, {30, 5}, {0, 3}}});
       }},
      {"dilatant soils, one thirty times as stiff",
       [](SceneDef& s) {
         s.materials[0].law = "mohr_coulomb", s.materials[0].dilatancy_angle = 20;
         MaterialDef gravel = test::soil("drucker_prager", 6e3, 30);
         gravel.name = "gravel", gravel.young_modulus = 30 * s.materials[0].young_modulus;
         gravel.dilatancy_angle = 30;
         s.materials.push_back(gravel);
         s.layers.push_back({"gravel", {{0, 0}, {30, 0}, {30, 5}, {0, 3}}});
       }},
      {"seismic and load",
       [](SceneDef& s) {
         s.kh = 0.2, s.kv = -0.1, s.loads = {{2, 9, 3e4, 1e4}};
       }},
      {"off the lattice", [](SceneDef& s) { s.jitter = 0.3; }},
      {"off the lattice, no bonds", [](SceneDef& s) { s.jitter = 0.45, s.bond = "none"; }},
      {"off the lattice, dilatant mohr-coulomb over clay, vertical face, load",
       [](SceneDef& s) {
         s.exterior = {{0, 0}, {30, 0}, {30, 4}, {16, 4}, {16, 12}, {0, 12}};
         MaterialDef clay = test::soil("undrained", 6e3, 0);
         clay.name = "clay";
         s.materials[0].law = "mohr_coulomb", s.materials[0].dilatancy_angle = 10;
         s.materials.push_back(clay);
         s.layers.push_back({"clay", {{0, 0}, {30, 0}, {30, 5}, {0, 3}}});
         s.kernel = "cubic_spline", s.loads = {{2, 9, 3e4, 1e4}}, s.jitter = 0.2;
       }},
      {"vertical face",
       [](SceneDef& s) {
         s.exterior = {{0, 0}, {30, 0}, {30, 4}, {16, 4}, {16, 12}, {0, 12}};
       }},
  };
  return list;
}

void compare(const SceneDef& scene, const Kernels& kernels, const char* name, bool keeps_gaps) {
  LatticeSimulation fast(scene, {}, kernels);
  const Model& m = fast.model();
  test::ReferenceStep slow(scene, fast.section(), m, 1);
  slow.keeps_gaps = keeps_gaps;
  // relaxation-like steps with plain momentum 0.9: enough plastic flow to touch every branch
  const double dt = 0.5;
  Array mass;
  mass.allocate(static_cast<std::size_t>(m.storage), 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.storage); ++i)
    mass[i] = m.scaled_mass[i] * 6 / fast.section().lattice.spacing.squaredNorm();
  Controls c;
  c.time_step = c.kick = dt, c.momentum = 0.9;
  c.mass = mass.data(), c.constants = fast.constants().data();
  c.dilation_cap = fast.dilation_cap().data(), c.keeps_gaps = keeps_gaps;
  const StepData d = fast.step_data_for_tests();
  Workers workers(1);
  std::vector<Sums> partial(m.chunks.size());
  Sums sums;
  constexpr int kSteps = 100;
  for (int n = 0; n < kSteps; ++n) {
    kernels.step(m.features.bond != BondLaw::kNone, m.off_lattice(), false)(d, c, workers, partial.data(), sums);
    const std::vector<Vec2> f = slow.internal_forces();
    for (std::size_t k = 0; k < f.size(); ++k) {
      const auto i = static_cast<std::size_t>(m.storage_of[k]);
      const Vec2 total = f[k] + Vec2(m.force_x[i], m.force_y[i]);
      slow.v[k] = 0.9 * slow.v[k] + dt / mass[i] * Vec2(m.free_x[i] * total.x(), m.free_y[i] * total.y());
      slow.u[k] += dt * slow.v[k];
    }
  }
  Real largest = 0, error = 0;
  std::int64_t yielded = 0;
  for (std::size_t k = 0; k < slow.u.size(); ++k) {
    const auto i = static_cast<std::size_t>(m.storage_of[k]);
    largest = std::max(largest, slow.u[k].norm());
    error = std::max(error, (slow.u[k] - Vec2(fast.state().displacement_x[i], fast.state().displacement_y[i])).norm());
  }
  for (const auto& [bond, strain] : slow.plastic_strain) yielded += strain.norm() > 0 ? 1 : 0;
  EXPECT_GT(largest, 0) << name;
  if (scene.materials[0].law != "elastic") {
    EXPECT_GT(yielded, 10) << name << ": the case must yield to test anything";
  }
  EXPECT_LE(error, 1e-12 * largest) << name << " with " << kernels.isa;
}

TEST(FastStep, EqualsThePlainStepForEveryLawAndInstructionSet) {
  for (const Kernels& kernels : all_kernels()) {
    if (!kernels.supported) continue;
    for (const Variant& v : variants()) {
      SceneDef scene = plain_scene();
      v.change(scene);
      for (const bool keeps_gaps : {false, true}) compare(scene, kernels, v.name, keeps_gaps);
    }
  }
}

TEST(FastStep, HasTheSameHashForAnyThreadCount) {
  std::uint64_t one = 0;
  for (int threads : {1, 2, 3, 4}) {
    SceneDef scene = test::slope(test::soil("mohr_coulomb", 5e3, 20, 5), 0.17);
    CompileOptions options;
    options.threads = threads;
    auto simulation = Simulation::compile(scene, options);
    simulation->relax(40, {});
    if (threads == 1) one = simulation->state_hash();
    EXPECT_NE(simulation->state_hash(), 0u);
    EXPECT_EQ(simulation->state_hash(), one) << threads << " threads";
  }
}

TEST(FastStep, GoesOnBitByBitAfterRestore) {
  auto simulation = Simulation::compile(test::slope(test::soil("drucker_prager", 5e3, 20), 0.5), {});
  simulation->relax(50, {});
  const auto saved = simulation->save();
  simulation->relax(70, {});
  const std::uint64_t there = simulation->state_hash();
  simulation->restore(*saved);
  simulation->relax(70, {});
  EXPECT_EQ(simulation->state_hash(), there);
}

}  // namespace
}  // namespace vbgpd
