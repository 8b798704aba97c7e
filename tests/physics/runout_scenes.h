// Scenes of the run-out tests: a free body, a block between rollers, a column that collapses.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

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
inline void load_by_gravity(Simulation& s, double equilibrium = 1e-5) {
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

/// Particles nearer than that to particle i; x: of all, x and y in turns.
inline std::vector<std::size_t> near(const std::vector<double>& x, std::size_t i, double reach) {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < x.size() / 2; ++j)
    if (j != i && std::hypot(x[2 * j] - x[2 * i], x[2 * j + 1] - x[2 * i + 1]) < reach) found.push_back(j);
  return found;
}

/// How many particles each mass has that hangs together by distances below `link`.
inline std::vector<std::size_t> pieces(const std::vector<double>& x, double link) {
  std::vector<bool> seen(x.size() / 2, false);
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i]) continue;
    seen[i] = true, sizes.push_back(0);
    for (std::vector<std::size_t> open{i}; !open.empty(); ++sizes.back()) {
      const std::size_t k = open.back();
      open.pop_back();
      for (const std::size_t j : near(x, k, link))
        if (!seen[j]) seen[j] = true, open.push_back(j);
    }
  }
  return sizes;
}

}  // namespace vbgpd::test
