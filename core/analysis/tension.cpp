#include "analysis/tension.h"

#include <cmath>

#include "analysis/cell_grid.h"

namespace vbgpd {

Real tension_depth(const Simulation& simulation) {
  const Section& section = simulation.section();
  std::vector<double> stress;
  simulation.read(find_field("stress"), stress);  // xx, yy, zz, xy
  std::vector<double> major;
  for (const Seed& s : section.seeds) {
    if (s.hold != Hold::kFree) continue;
    const double* const at = stress.data() + 4 * major.size();
    const bool may_crack =
        std::isnan(simulation.scene().materials[static_cast<std::size_t>(s.material)].tension_cutoff);
    major.push_back(may_crack ? (at[0] + at[1]) / 2 + std::hypot((at[0] - at[1]) / 2, at[3]) : 0);
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
