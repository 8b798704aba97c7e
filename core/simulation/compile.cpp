// compile: the one place that sees all choices.
#include "geometry/check.h"
#include "scene/validate.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {

std::unique_ptr<Simulation> Simulation::compile(const SceneDef& scene, const CompileOptions& options) {
  std::vector<Issue> issues = validate(scene);
  const std::vector<Issue> geometric = check_geometry(scene);
  issues.insert(issues.end(), geometric.begin(), geometric.end());
  Issue all;
  bool first = true;
  for (const Issue& issue : issues) {
    if (issue.severity != Severity::kError) continue;
    if (first) all = issue;
    else all.text += "\n" + issue.text;
    first = false;
  }
  if (!first) throw Error(all);
  return std::make_unique<LatticeSimulation>(scene, options, best_kernels());
}

}  // namespace vbgpd
