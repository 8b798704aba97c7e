// Step cost from 1e3 to 1e6 particles, and the factor of safety of Griffiths & Lane's example 1. CPU time of one
// thread.
#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "analysis/job.h"
#include "exchange/scene_buffer.h"
#include "exchange/scene_text.h"
#include "simulation/simulation.h"

namespace vbgpd {
namespace {

SceneDef scene(const std::string& name) {
  std::ifstream file(std::string(VBGPD_SCENES_DIR) + "/" + name + ".json");
  std::stringstream text;
  text << file.rdbuf();
  return scene_from_flatbuffer(scene_text_to_flatbuffer(text.str(), name));
}

/// Relaxation steps of example 1 near failure (most bonds plastic), by bond law and number of particles.
void step_cost(benchmark::State& state, const char* bond, const char* law) {
  SceneDef s = scene("gl_1");
  s.bond = bond;
  s.materials[0].law = law;
  s.spacing = std::sqrt(220.0 / static_cast<double>(state.range(0)));  // area of the section 220 m2
  const auto simulation = Simulation::compile(s, {});
  simulation->set("strength_reduction_factor", 1.5);
  simulation->relax(100, {});
  const std::int64_t steps = std::max<std::int64_t>(2, 2000000 / simulation->particle_count());
  for (auto _ : state) simulation->relax(steps, {});
  const auto count = static_cast<double>(simulation->particle_count());
  state.counters["particles"] = count;
  state.counters["bonds"] = static_cast<double>(simulation->bond_count());
  state.counters["plastic_bonds"] = simulation->get("plastic_bonds");
  state.counters["bytes_per_particle"] = simulation->get("bytes") / count;
  state.counters["particle_steps_per_second"] =
      benchmark::Counter(count * static_cast<double>(steps), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(step_cost, virtual_bond_drucker_prager, "virtual_bond", "drucker_prager")
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step_cost, virtual_bond_mohr_coulomb, "virtual_bond", "mohr_coulomb")
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step_cost, none_drucker_prager, "none", "drucker_prager")
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);

/// Factor of safety of example 1 on one grid, bracket 0.005, verified; range = particles per slope height.
void factor_of_safety(benchmark::State& state, const char* law, int levels) {
  SceneDef s = scene("gl_1");
  s.materials[0].law = law;
  s.spacing = 10.0 / static_cast<double>(state.range(0));
  double found = 0;
  for (auto _ : state) {
    const auto simulation = Simulation::compile(s, {});
    const auto job = make_strength_reduction(*simulation);
    job->set("levels", levels);
    job->run(0, {});
    found = job->result().factor_of_safety;
    state.counters["steps"] = static_cast<double>(job->result().steps);
    state.counters["particles"] = static_cast<double>(simulation->particle_count());
  }
  state.counters["factor_of_safety"] = found;
}
BENCHMARK_CAPTURE(factor_of_safety, one_grid_drucker_prager, "drucker_prager", 1)
    ->Arg(20)
    ->Arg(40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_of_safety, two_grids_drucker_prager, "drucker_prager", 2)
    ->Arg(20)
    ->Arg(40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_of_safety, one_grid_mohr_coulomb, "mohr_coulomb", 1)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vbgpd

BENCHMARK_MAIN();
