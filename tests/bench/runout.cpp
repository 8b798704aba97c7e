// A step of a run-out in the middle of its collapse: Bui's column of bars, everything on (bonds, guard, viscosity,
// diffusion, rough base and smooth wall with their images).
#include "scenes.h"
#include "simulation/flow_simulation.h"

namespace vbgpd::bench {
namespace {

SceneDef bars(double rows) {
  SceneDef s;
  MaterialDef m;
  m.name = "bars", m.law = "drucker_prager", m.unit_weight = 2650 * 9.81, m.young_modulus = 0.84e6;
  m.poisson_ratio = 0.3, m.cohesion = 0, m.friction_angle = 19.8;
  s.materials = {m};
  s.exterior = {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}};
  s.layers.push_back({m.name, {}});
  BoundaryDef base, wall;
  base.side = "base", base.kind = BoundaryKind::kFixed;
  wall.side = "left", wall.kind = BoundaryKind::kRoller;
  s.boundaries = {base, wall};
  s.spacing = 0.1 / rows;
  return s;
}

void runout(benchmark::State& state) {
  CompileOptions options;
  options.threads = 1;
  FlowSimulation simulation(LatticeSimulation(bars(static_cast<double>(state.range(0))), options, best_kernels()));
  simulation.advance_to(0.15, [] { return Status::kOk; });
  const std::uint64_t hash = simulation.state_hash();
  const auto middle = simulation.save();
  const std::int64_t steps = std::max<std::int64_t>(50, 400000 / simulation.particle_count());
  double searches = 0;
  for (auto _ : state) {
    state.PauseTiming();
    simulation.restore(*middle);
    searches = simulation.get("neighbour_searches");
    state.ResumeTiming();
    simulation.step(steps, nullptr);
  }
  describe(state, simulation, hash);
  const double work = static_cast<double>(simulation.particle_count() * steps);
  state.counters["steps_per_search"] = static_cast<double>(steps) / (simulation.get("neighbour_searches") - searches);
  state.counters["ns_per_particle_step"] =
      benchmark::Counter(work * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(runout)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vbgpd::bench
