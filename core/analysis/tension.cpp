#include "analysis/tension.h"

#include <cmath>

#include "analysis/cell_grid.h"
#include "analysis/stiffness_contrast.h"

namespace vbgpd {

Real tension_depth(const Simulation& simulation) {
  const Section& section = simulation.section();
  std::vector<double> stress;
  simulation.read(find_field("stress"), stress);  // xx, yy, zz, xy
  const std::vector<MaterialDef>& soils = simulation.scene().materials;
  std::vector<bool> may_crack(soils.size(), false);
  for (const std::size_t soil : yielding_soils(simulation)) may_crack[soil] = std::isnan(soils[soil].tension_cutoff);
  std::vector<double> major;
  for (const Seed& s : section.seeds) {
    if (s.hold != Hold::kFree) continue;
    const double* const at = stress.data() + 4 * major.size();
    const bool counts = may_crack[static_cast<std::size_t>(s.material)];
    major.push_back(counts ? (at[0] + at[1]) / 2 + std::hypot((at[0] - at[1]) / 2, at[3]) : 0);
  }
  const CellGrid grid(section, major);
  Index deepest = 0;
  for (Index i = 0; i < grid.width(); ++i) {
    Index top = grid.height() - 1, cells = 0;
    while (top >= 0 && !grid.soil(i, top)) --top;
    while (grid.soil(i, top - cells) && grid.at(i, top - cells) > 0) ++cells;
    deepest = std::max(deepest, cells);
  }
  return static_cast<Real>(deepest) * section.lattice.spacing.y();
}

}  // namespace vbgpd
