// compile: the one place that sees all choices.
#include "geometry/check.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {

std::unique_ptr<Simulation> Simulation::compile(const SceneDef& scene, const CompileOptions& options) {
  Issue all;
  bool first = true;
  for (const Issue& issue : all_issues(scene)) {
    if (issue.severity != Severity::kError) continue;
    if (first) all = issue;
    else all.text += "\n" + issue.text;
    first = false;
  }
  if (!first) throw Error(all);
  return std::make_unique<LatticeSimulation>(scene, options, best_kernels());
}

}  // namespace vbgpd
