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

/// Inverses of four symmetric moment matrices with their eigenvalues kept above a floor: a particle with few neighbours
/// gets a smaller gradient, never a wild one, and nothing switches.
struct Inverse {
  Pack xx, xy, yy;
};
VBGPD_INLINE Inverse floored_inverse(Pack xx, Pack xy, Pack yy, double floor) {
  const Pack trace = xx + yy, determinant = xx * yy - xy * xy, inverse = 1.0 / determinant;
  const auto low = (determinant <= floor * (trace - floor)) | (trace <= 2 * floor);  // an eigenvalue below the floor
  const Inverse plain{yy * inverse, -xy * inverse, xx * inverse};
  if (!any(low)) return plain;
  const Pack mean = 0.5 * trace, half = 0.5 * (xx - yy), radius = root(half * half + xy * xy);
  const Pack least = broadcast(floor), large = larger(mean + radius, least), small = larger(mean - radius, least);
  const Pack p = 0.5 * (1.0 / large + 1.0 / small), q = 0.5 * (1.0 / large - 1.0 / small);
  const auto round = radius <= Pack{};
  const Pack scale = select(round, Pack{}, q / select(round, broadcast(1), radius));
  return {select(low, p + scale * half, plain.xx), select(low, scale * xy, plain.xy),
          select(low, p - scale * half, plain.yy)};
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
