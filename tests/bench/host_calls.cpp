// A host that drives the engine step by step: what a call of one step costs beside a step of a call of a thousand.
#include "scenes.h"
#include "simulation/flow_simulation.h"

namespace vbgpd::bench {
namespace {

/// A thousand dynamic steps in calls of so many each, with the monitors that every call of the C face returns.
void in_calls(benchmark::State& state, Simulation& simulation) {
  constexpr std::int64_t kSteps = 1000;
  simulation.step(10, nullptr);
  const auto begin = simulation.save();
  const std::uint64_t hash = simulation.state_hash();
  for (auto _ : state) {
    state.PauseTiming();
    simulation.restore(*begin);
    state.ResumeTiming();
    for (std::int64_t done = 0; done < kSteps; done += state.range(0))
      benchmark::DoNotOptimize(simulation.monitors_after(simulation.step(state.range(0), nullptr)));
  }
  describe(state, simulation, hash);
  state.counters["ns_per_particle_step"] =
      benchmark::Counter(static_cast<double>(simulation.particle_count() * kSteps) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

std::unique_ptr<LatticeSimulation> failing_slope() {
  CompileOptions options;
  options.threads = 1;
  auto simulation = std::make_unique<LatticeSimulation>(sample_scene("gl_1"), options, best_kernels());
  simulation->set("strength_reduction_factor", 1.5);
  return simulation;
}

void host_calls_lattice(benchmark::State& state) { in_calls(state, *failing_slope()); }
BENCHMARK(host_calls_lattice)->Arg(1000)->Arg(1)->Unit(benchmark::kMillisecond);

void host_calls_runout(benchmark::State& state) {
  FlowSimulation simulation(*failing_slope());
  in_calls(state, simulation);
}
BENCHMARK(host_calls_runout)->Arg(1000)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vbgpd::bench
