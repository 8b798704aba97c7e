// Which seed sits in which lattice cell. Seeds are sorted by (ix, iy), so a column is a short run found by offset.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/section.h"

namespace vbgpd {

class CellIndex {
 public:
  CellIndex() = default;

  /// `seeds` sorted by (ix, iy); must outlive this and keep its order.
  explicit CellIndex(const std::vector<Seed>& seeds) : seeds_(&seeds) {
    if (seeds.empty()) return;
    first_ = seeds.front().ix;
    start_.assign(static_cast<std::size_t>(seeds.back().ix - first_) + 2, static_cast<Index>(seeds.size()));
    for (std::size_t i = seeds.size(); i-- > 0;) start_[seeds[i].ix - first_] = static_cast<Index>(i);
    for (std::size_t c = start_.size() - 1; c-- > 0;) start_[c] = std::min(start_[c], start_[c + 1]);
  }

  /// Index of the seed in cell (ix, iy), -1 when there is none.
  Index find(Index ix, Index iy) const {
    if (start_.empty() || ix < first_ || ix - first_ + 1 >= static_cast<Index>(start_.size())) return -1;
    const Index begin = start_[ix - first_], end = start_[ix - first_ + 1];
    if (begin == end) return -1;
    const auto& seeds = *seeds_;
    const std::int64_t guess =
        begin + (static_cast<std::int64_t>(iy) - seeds[begin].iy);  // right when the column has no gap
    if (guess < begin) return -1;
    if (guess < end && seeds[guess].iy == iy) return static_cast<Index>(guess);
    const auto last = seeds.begin() + end;
    const auto at = std::lower_bound(seeds.begin() + begin, last, iy, [](const Seed& s, Index y) { return s.iy < y; });
    return at != last && at->iy == iy ? static_cast<Index>(at - seeds.begin()) : -1;
  }

 private:
  const std::vector<Seed>* seeds_ = nullptr;
  Index first_ = 0;
  std::vector<Index> start_;
};

/// The soil seed nearest to a cell, in spacings, within `reach` cells; -1 when there is none.
template <class Accept>
Index nearest_seed(const CellIndex& index, Index ix, Index iy, Index reach, const Vec2& spacing, Accept accept) {
  Index best = -1;
  Real least = std::numeric_limits<Real>::infinity();
  const Real h = spacing.minCoeff();
  for (Index ring = 0; ring <= reach && ring * h < least; ++ring)
    for (Index dx = -ring; dx <= ring; ++dx)
      for (Index dy = -ring; dy <= ring; dy += (dx == -ring || dx == ring) ? 1 : std::max<Index>(2 * ring, 1)) {
        const Index i = index.find(ix + dx, iy + dy);
        const Real distance = Vec2(dx * spacing.x(), dy * spacing.y()).norm();
        if (i < 0 || distance >= least || !accept(i)) continue;
        best = i;
        least = distance;
      }
  return best;
}

}  // namespace vbgpd
