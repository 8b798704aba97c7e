// What a scene does not use has no bytes, and what it uses has those of its arrays and no more.
#include "simulation/plan.h"

#include <gtest/gtest.h>

#include <string_view>

#include "analysis/forecast.h"
#include "physics/scenes.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {
namespace {

using test::slope;
using test::soil;

std::unique_ptr<LatticeSimulation> compiled(const SceneDef& scene) {
  return std::make_unique<LatticeSimulation>(scene, CompileOptions{}, best_kernels());
}

Feature feature(const Simulation& simulation, std::string_view name) {
  for (const Feature& f : simulation.plan())
    if (name == f.name) return f;
  ADD_FAILURE() << "no feature " << name;
  return {};
}

std::size_t bytes(const Feature& f) { return f.particle_bytes + f.bond_bytes; }

SceneDef dry_elastic(const char* bond) {
  SceneDef s = slope(soil("elastic", 10e3, 0), 1);
  s.bond = bond;
  return s;
}

SceneDef everything() {
  SceneDef s = slope(soil("mohr_coulomb", 10e3, 20, 5), 1);
  s.materials[0].tension_cutoff = 1e3;
  s.materials.push_back(soil("undrained", 30e3, 0));
  s.materials[1].name = "clay", s.materials[1].cohesion_gradient = 2e3, s.materials[1].cohesion_datum = 5;
  s.materials[1].young_modulus = 2e8;
  s.layers.push_back({"clay", {{0, 0}, {32, 0}, {28.8, 1.6}, {0, 4}}});
  s.loads = {{2, 8, 20e3, 20e3}};
  s.kh = 0.05;
  s.boundaries[0].kind = BoundaryKind::kVelocity;
  s.jitter = 0.1;
  return s;
}

TEST(Plan, AddsUpToAllBytes) {
  for (const SceneDef& s : {dry_elastic("none"), dry_elastic("virtual_bond"), everything()}) {
    const auto simulation = compiled(s);
    for (int stage = 0; stage < 3; ++stage) {
      std::size_t sum = 0;
      for (const Feature& f : simulation->plan()) sum += bytes(f);
      EXPECT_EQ(static_cast<double>(sum), simulation->get("bytes")) << s.bond << " stage " << stage;
      if (stage == 0) simulation->relax(3, {});
      if (stage == 1) simulation->step(3, nullptr);
    }
  }
}

TEST(Plan, WhatIsLeftOutHasNoBytes) {
  int left_out = 0;
  for (const SceneDef& s : {dry_elastic("none"), dry_elastic("virtual_bond"), everything()})
    for (const Feature& f : compiled(s)->plan()) {
      if (f.used) continue;
      ++left_out;
      EXPECT_EQ(bytes(f), 0u) << f.name;
    }
  EXPECT_GT(left_out, 20);
}

TEST(Plan, OfTheSimplestSceneLeavesEverythingOut) {
  const auto simulation = compiled(dry_elastic("none"));
  for (const char* name :
       {"virtual bonds", "plasticity", "volumetric plasticity", "cohesion gradient", "several materials", "dilatancy",
        "dilatancy across stiffness", "uneven stiffness", "tension cut-off", "seismic coefficients", "surface loads",
        "moving boundaries", "damping", "energy ledger", "dilatant volume", "fields and monitors", "workers",
        "mohr_coulomb law", "jitter"})
    EXPECT_FALSE(feature(*simulation, name).used) << name;
  EXPECT_TRUE(feature(*simulation, "elastic law").used);
}

TEST(Plan, OfTheFullSceneUsesEverything) {
  const auto simulation = compiled(everything());
  for (const char* name :
       {"virtual bonds", "plasticity", "volumetric plasticity", "cohesion gradient", "dilatancy across stiffness",
        "uneven stiffness", "several materials", "dilatancy", "tension cut-off", "seismic coefficients",
        "surface loads", "moving boundaries", "guided walls", "mohr_coulomb law", "undrained law", "jitter"})
    EXPECT_TRUE(feature(*simulation, name).used) << name;
  EXPECT_FALSE(feature(*simulation, "damping").used);
  simulation->set("damping", 0.3);
  EXPECT_TRUE(feature(*simulation, "damping").used);
}

/// So many arrays over all particles; each may be staggered by less than one page.
void expect_arrays(const Feature& f, std::size_t arrays, std::size_t storage) {
  constexpr std::size_t kStagger = 64 * 5 * 13;
  EXPECT_GE(f.particle_bytes, arrays * 8 * storage) << f.name;
  EXPECT_LE(f.particle_bytes, arrays * (8 * storage + kStagger)) << f.name;
}

TEST(Plan, BytesAreThoseOfTheArrays) {
  const auto simulation = compiled(everything());
  const Model& m = simulation->model();
  const auto storage = static_cast<std::size_t>(m.storage);
  const auto records = static_cast<std::size_t>(m.slots * m.width);
  expect_arrays(feature(*simulation, "virtual bonds"), 2, storage);  // pair force x, y
  EXPECT_EQ(feature(*simulation, "virtual bonds").bond_bytes, m.packs.size() * sizeof(BondPack));
  expect_arrays(feature(*simulation, "volumetric plasticity"), 3, storage);  // theta^p, the gap, the cap
  expect_arrays(feature(*simulation, "dilatant volume"), 1, storage);
  expect_arrays(feature(*simulation, "cohesion gradient"), 1, storage);
  expect_arrays(feature(*simulation, "dilatancy across stiffness"), 1, storage);
  const Feature plasticity = feature(*simulation, "plasticity");
  EXPECT_EQ(plasticity.particle_bytes, 0u);
  EXPECT_EQ(plasticity.bond_bytes - plasticity.bond_bytes % (3 * 8 * records), 3 * 8 * records);  // xx, yy, xy
  const double at_rest = simulation->get("bytes");
  simulation->relax(1, {});
  EXPECT_EQ(simulation->get("bytes"), at_rest);
  EXPECT_EQ(bytes(feature(*simulation, "energy ledger")), 0u);
  simulation->step(1, nullptr);
  // two for the work of volume; walls that are moved do work that is not booked, so there is no audit to keep a state
  // for
  expect_arrays(feature(*simulation, "energy ledger"), 2, storage);
}

TEST(Plan, OneFeatureMoreCostsItsOwnArraysOnly) {
  const auto elastic = compiled(dry_elastic("virtual_bond"));
  SceneDef s = dry_elastic("virtual_bond");
  s.materials[0] = soil("undrained", 10e3, 0);
  const auto undrained = compiled(s);
  EXPECT_EQ(undrained->get("bytes") - elastic->get("bytes"),
            static_cast<double>(bytes(feature(*undrained, "plasticity"))));
  s.materials[0] = soil("drucker_prager", 10e3, 20);
  const auto frictional = compiled(s);
  EXPECT_EQ(frictional->get("bytes") - undrained->get("bytes"),
            static_cast<double>(bytes(feature(*frictional, "volumetric plasticity"))));
}

TEST(Forecast, MeasuresWithoutATrace) {
  const auto simulation = compiled(slope(soil("drucker_prager", 10e3, 20), 1));
  simulation->step(5, nullptr);
  const std::uint64_t hash = simulation->state_hash();
  const double time = simulation->get("time");
  const Forecast f = forecast_strength_reduction(*simulation);
  EXPECT_EQ(simulation->state_hash(), hash);
  EXPECT_EQ(simulation->get("time"), time);
  EXPECT_GT(f.step_seconds, 0);
  EXPECT_NEAR(f.seconds, f.steps * f.step_seconds, 1e-12);
  EXPECT_GT(f.bytes, simulation->get("bytes"));
}

}  // namespace
}  // namespace vbgpd
