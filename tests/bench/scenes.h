// Scenes and columns that all benchmarks share.
#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "../sample_scene.h"
#include "simulation/simulation.h"
#include "step/kernels.h"

namespace vbgpd::bench {

/// The spacing that gives about so many particles of soil.
inline double spacing_for(const SceneDef& s, std::int64_t particles) {
  double twice_area = 0;
  for (std::size_t i = 0, j = s.exterior.size() - 1; i < s.exterior.size(); j = i++)
    twice_area += s.exterior[j].x * s.exterior[i].y - s.exterior[i].x * s.exterior[j].y;
  return std::sqrt(std::fabs(twice_area) / 2 / static_cast<double>(particles));
}

/// Fixed work from the start of a simulation, so that the hash afterwards names the result whatever the timing did.
inline void warm_up(Simulation& simulation) {
  constexpr std::int64_t kSteps = 100;
  simulation.relax(kSteps, {});
}

/// The columns of every row: N, bonds, threads, bytes per particle; instruction set and hash as the label.
inline void describe(benchmark::State& state, const Simulation& simulation, std::uint64_t hash) {
  const auto count = static_cast<double>(simulation.particle_count());
  state.counters["N"] = count;
  state.counters["bonds"] = static_cast<double>(simulation.bond_count());
  state.counters["threads"] = simulation.options().threads;
  state.counters["bytes_per_particle"] = simulation.get("bytes") / count;
  char label[80];
  std::snprintf(label, sizeof label, "%s %016llx", std::string(best_kernels().isa).c_str(),
                static_cast<unsigned long long>(hash));
  state.SetLabel(label);
}

/// Relaxation steps of a scene and their cost; the column that counts is ns_per_particle_step (CPU time).
inline void step_cost(benchmark::State& state, const SceneDef& s, double factor, int threads = 1) {
  CompileOptions options;
  options.threads = threads;
  const auto simulation = Simulation::compile(s, options);
  simulation->set("strength_reduction_factor", factor);
  warm_up(*simulation);
  const std::uint64_t hash = simulation->state_hash();
  constexpr std::int64_t kWork = 2000000;
  const std::int64_t steps = std::max<std::int64_t>(2, kWork / simulation->particle_count());
  for (auto _ : state) simulation->relax(steps, {});
  describe(state, *simulation, hash);
  const double work = static_cast<double>(simulation->particle_count() * steps);
  state.counters["plastic_bonds"] = simulation->get("plastic_bonds");
  state.counters["ns_per_particle_step"] =
      benchmark::Counter(work * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace vbgpd::bench
