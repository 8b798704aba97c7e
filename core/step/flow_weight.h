// The pair weight of the run-out step: omega(r) = -W'(r)/r of Wendland C2, so that the moment matrix is 1 in the bulk.
#pragma once

#include "step/flow_data.h"
#include "step/flow_quads.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// 35 / (4 pi h^4) (1 - r/2h)^3, 0 beyond the support; r given.
VBGPD_INLINE Pack pair_weight(const FlowControls& c, Pack r) {
  const Pack s = larger(1.0 - r * c.inverse_support, Pack{});
  return c.weight_scale * s * s * s;
}

/// Inverse of the symmetric moment matrix with its eigenvalues kept above a floor: a particle with few neighbours gets
/// a smaller gradient, never a wild one, and nothing switches.
struct Inverse {
  double xx, xy, yy;
};
VBGPD_INLINE Inverse floored_inverse(double xx, double xy, double yy, double floor) {
  const double trace = xx + yy, determinant = xx * yy - xy * xy;
  if (determinant > floor * (trace - floor) && trace > 2 * floor) {  // both above the floor
    const double inverse = 1 / determinant;
    return {yy * inverse, -xy * inverse, xx * inverse};
  }
  const double mean = 0.5 * trace, half = 0.5 * (xx - yy), radius = root(half * half + xy * xy);
  const double large = larger(mean + radius, floor), small = larger(mean - radius, floor);
  const double p = 0.5 * (1 / large + 1 / small), q = 0.5 * (1 / large - 1 / small);
  const double scale = radius > 0 ? q / radius : 0;
  return {p + scale * half, scale * xy, p - scale * half};
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
