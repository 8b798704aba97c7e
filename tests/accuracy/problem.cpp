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

double polar_stress_error(const Simulation& simulation, const Point& centre, double scale,
                          const std::function<double(double)>& radial, const std::function<double(double)>& hoop) {
  const std::vector<double> x = field(simulation, "position"), stress = field(simulation, "stress"),
                            boundary = field(simulation, "boundary");
  double sum = 0;
  std::size_t soil = 0;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    if (boundary[i] >= 0) continue;
    const double to_x = x[2 * i] - centre.x, to_y = x[2 * i + 1] - centre.y;
    const double r = std::hypot(to_x, to_y), c = to_x / r, d = to_y / r;
    const double* const s = stress.data() + 4 * i;
    const double off_r = c * c * s[0] + 2 * c * d * s[3] + d * d * s[1] - radial(r);
    const double off_h = d * d * s[0] - 2 * c * d * s[3] + c * c * s[1] - hoop(r);
    sum += (off_r * off_r + off_h * off_h) / 2, ++soil;
  }
  return std::sqrt(sum / static_cast<double>(soil)) / scale;
}

Outcome factor_of_safety_error(Simulation& simulation, int levels, double exact) {
  const auto job = make_strength_reduction(simulation);
  job->set("levels", levels);
  job->run(0, {});
  const JobResult& r = job->result();
  return outcome(simulation, std::fabs(r.factor_of_safety / exact - 1), r.steps);
}

}  // namespace vbgpd::accuracy
