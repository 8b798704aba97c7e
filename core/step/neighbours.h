// Sums over the neighbours of a block of particles, with the operator omega_ij xi_ij of VB1.
#pragma once

#include "base/pack.h"
#include "step/sites.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// A tensor of every particle of a block.
struct TensorSum {
  Pack xx{}, xy{}, yx{}, yy{};
};

/// Calls term(sum, j, omega_ij xi_x, omega_ij xi_y) for every pack of neighbours j of a block; lanes that are no
/// neighbours have no weight. Two sums side by side, so that one addition need not wait for the last.
template <class Sites, class Term>
VBGPD_INLINE TensorSum over_neighbours(const StepData& d, const Block& block, const Term& term) {
  TensorSum even, odd;
  const auto add = [&](TensorSum & sum, int n) __attribute__((always_inline)) {
    Pack gx, gy;
    Sites::operator_of(d, n, block, gx, gy);
    term(sum, d.neighbours[n].j, gx, gy);
  };
  int n = block.neighbours_begin;
  for (; n + 1 < block.neighbours_end; n += 2) add(even, n), add(odd, n + 1);
  if (n < block.neighbours_end) add(even, n);
  return {even.xx + odd.xx, even.xy + odd.xy, even.yx + odd.yx, even.yy + odd.yy};
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
