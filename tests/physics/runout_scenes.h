// Scenes of the run-out tests: a free body, a block between rollers, a column that collapses.
#pragma once

#include <cmath>
#include <memory>

#include "physics/scenes.h"
#include "simulation/flow_simulation.h"

namespace vbgpd::test {

/// A body without weight and without walls.
inline SceneDef free_body(const MaterialDef& material, double width, double height, double spacing) {
  SceneDef s = block(material, width, height, spacing);
  BoundaryDef none;
  none.side = "base", none.kind = BoundaryKind::kFree;
  s.boundaries = {none};
  s.kv = -1;
  return s;
}

/// Bui's column of aluminium bars (2008): 0.2 m x 0.1 m, 19.8 degrees, no cohesion; rough base, smooth wall on the
/// left.
inline SceneDef bar_column(double rows) {
  MaterialDef bars = soil("drucker_prager", 0, 19.8);
  bars.unit_weight = 2650 * 9.81, bars.young_modulus = 0.84e6;
  SceneDef s = block(bars, 0.2, 0.1, 0.1 / rows);
  s.boundaries.resize(2);
  return s;
}

inline std::unique_ptr<FlowSimulation> runout(const SceneDef& scene, int threads = 1, const FlowOptions& options = {}) {
  CompileOptions compile;
  compile.threads = threads;
  return std::make_unique<FlowSimulation>(LatticeSimulation(scene, compile, best_kernels()), options);
}

/// Gravity without strengths, then at rest.
inline void load_by_gravity(FlowSimulation& s, double equilibrium = 1e-5) {
  RelaxOptions elastic;
  elastic.elastic = true;
  for (int k = 0; k < 400; ++k)
    if (s.relax(50, elastic).unbalanced_force_ratio < equilibrium) break;
  s.halt();
}

inline std::vector<double> field(const Simulation& s, const char* name) {
  std::vector<double> values;
  s.read(find_field(name), values);
  return values;
}

inline double smallest_distance(const FlowSimulation& s) {
  const std::vector<double> x = field(s, "position");
  double least = 1e300;
  for (std::size_t i = 0; i < x.size(); i += 2)
    for (std::size_t j = 0; j < i; j += 2) least = std::min(least, std::hypot(x[i] - x[j], x[i + 1] - x[j + 1]));
  return least;
}

}  // namespace vbgpd::test
