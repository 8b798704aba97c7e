// Which record of the plastic strain belongs to which bond.
#pragma once

#include "state/model.h"

namespace vbgpd {

/// Calls f(pack, lane, i, j, index of plastic xx) for every bond, i and j in storage order; i == j without bonds. The
/// yy and xy of a record follow one and two pack widths behind.
template <class F>
void for_each_record(const Model& m, F&& f) {
  const bool bonded = m.features.bond != BondLaw::kNone;
  for (const BondPack& p : m.packs)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(p.i + l), j = static_cast<std::size_t>(p.j + l);
      if (((p.lanes >> l) & 1) == 0 || m.seed_of[i] < 0 || m.seed_of[j] < 0) continue;
      const auto first =
          bonded ? static_cast<std::size_t>(p.slot) * static_cast<std::size_t>(m.width) : static_cast<std::size_t>(p.i);
      f(p, l, i, j, 3 * first + static_cast<std::size_t>(l));
    }
}

}  // namespace vbgpd
