// A whole factor of safety: Griffiths & Lane's example 1, bracket 0.005, verified; range = particles per slope height.
#include "analysis/job.h"
#include "scenes.h"

namespace vbgpd::bench {
namespace {

void factor_of_safety(benchmark::State& state, const char* law, int levels) {
  SceneDef s = sample_scene("gl_1");
  s.materials[0].law = law;
  s.spacing = 10.0 / static_cast<double>(state.range(0));
  std::unique_ptr<Simulation> simulation;
  JobResult result;
  for (auto _ : state) {
    simulation = Simulation::compile(s, {});
    const auto job = make_strength_reduction(*simulation);
    job->set("levels", levels);
    job->run(0, {});
    result = job->result();
  }
  describe(state, *simulation, simulation->state_hash());
  state.counters["steps"] = static_cast<double>(result.steps);
  state.counters["factor_of_safety"] = result.factor_of_safety;
  state.counters["error_estimate"] = result.error_estimate;
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
}  // namespace vbgpd::bench
