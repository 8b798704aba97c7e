// What problems have in common: scenes, reading, rest, a factor of safety.
#include "problem.h"

#include <cmath>

#include "analysis/job.h"

namespace vbgpd::accuracy {

std::vector<double> field(const Simulation& simulation, const char* name) {
  std::vector<double> values;
  simulation.read(find_field(name), values);
  return values;
}

MaterialDef elastic_material() {
  MaterialDef m;
  m.name = "soil", m.law = "elastic";
  m.unit_weight = 20e3, m.young_modulus = 1e8, m.poisson_ratio = 0.3;
  return m;
}

SceneDef rectangle(const SceneDef& choice, const MaterialDef& material, double width, double height) {
  SceneDef s = choice;
  s.exterior = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  s.materials = {material};
  s.layers = {{material.name, {}}};
  s.boundaries = {held("base", BoundaryKind::kFree)};  // an empty list would mean base and sides held
  return s;
}

BoundaryDef held(const char* side, BoundaryKind kind) {
  BoundaryDef b;
  b.side = side, b.kind = kind;
  return b;
}

std::int64_t relax_to_rest(Simulation& simulation, double rest) {
  RelaxOptions elastic;
  elastic.elastic = true;
  std::int64_t steps = 0;
  for (constexpr std::int64_t kMost = 200000; steps < kMost;) {
    const RelaxReport r = simulation.relax(10, elastic);
    steps += r.steps;
    if (r.unbalanced_force_ratio < rest) break;
  }
  return steps;
}

Outcome outcome(const Simulation& simulation, double error, std::int64_t steps) {
  return {error, simulation.particle_count(), steps, simulation.get("bytes"), simulation.state_hash()};
}

Outcome factor_of_safety_error(Simulation& simulation, int levels) {
  const auto job = make_strength_reduction(simulation);
  job->set("levels", levels);
  job->run(0, {});
  const JobResult& r = job->result();
  return outcome(simulation, std::fabs(r.factor_of_safety - 1), r.steps);
}

}  // namespace vbgpd::accuracy
