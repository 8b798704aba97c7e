// Particle values on the cells of their lattice, for everything that looks at neighbours.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "simulation/simulation.h"

namespace vbgpd {

/// A rectangle of cells around a section; NaN where there is no soil particle.
class CellGrid {
 public:
  CellGrid(const Section& section, const std::vector<double>& by_id) : lattice_(section.lattice) {
    bool first = true;
    for (const Seed& s : section.seeds) {
      if (s.hold != Hold::kFree) continue;
      if (first) x0_ = x1_ = s.ix, y0_ = y1_ = s.iy;
      first = false;
      x0_ = std::min(x0_, s.ix), x1_ = std::max(x1_, s.ix), y0_ = std::min(y0_, s.iy), y1_ = std::max(y1_, s.iy);
    }
    --x0_, --y0_, ++x1_, ++y1_;  // a rim of empty cells
    values_.assign(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()),
                   std::numeric_limits<double>::quiet_NaN());
    std::size_t id = 0;  // soil particles are numbered in seed order, before the walls
    for (const Seed& s : section.seeds) {
      if (s.hold != Hold::kFree) continue;
      if (s.active) at(s.ix - x0_, s.iy - y0_) = by_id[id];
      ++id;
    }
  }
  Index width() const { return x1_ - x0_ + 1; }
  Index height() const { return y1_ - y0_ + 1; }
  double& at(Index i, Index j) {
    return values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(i)];
  }
  double at(Index i, Index j) const { return const_cast<CellGrid*>(this)->at(i, j); }
  bool inside(Index i, Index j) const { return i >= 0 && j >= 0 && i < width() && j < height(); }
  bool soil(Index i, Index j) const { return inside(i, j) && at(i, j) == at(i, j); }
  Vec2 center(Index i, Index j) const { return lattice_.center(i + x0_, j + y0_); }
  const Lattice& lattice() const { return lattice_; }
  std::vector<double>& values() { return values_; }
  const std::vector<double>& values() const { return values_; }

 private:
  Lattice lattice_;
  Index x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0;
  std::vector<double> values_;
};

}  // namespace vbgpd
