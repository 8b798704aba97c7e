// What keeps particles apart besides their stress: viscosity on approach and a short-range guard. Both follow from the
// motion alone and are summed with the velocity gradient, where positions and velocities are at hand.
#pragma once

#include "step/flow_weight.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

struct FlowApproach {
  Pack hx{}, hy{};            ///< viscosity
  Pack sx{}, sy{}, energy{};  ///< guard
};

/// Monaghan's viscosity on approach: V_i V_j rho omega (alpha c h) (v . xi)/(r2 + 0.01 h2) xi, v . xi < 0.
///
/// mass: rho V_i V_j
VBGPD_INLINE void add_viscosity(const FlowControls& c, Pack x, Pack y, Pack r2, Pack vx, Pack vy, Pack weight,
                                Pack mass, FlowApproach& s) {
  const Pack closing = smaller(vx * x + vy * y, Pack{});
  const Pack drag = c.viscosity * closing / (r2 + c.softening) * (weight * mass);  // the division waits for no root
  s.hx += drag * x, s.hy += drag * y;
}

/// Guard of four pairs: kappa (K + 4G/3) (b s - r), s the mean side of the two particles. constants: of all particles.
VBGPD_INLINE void add_guard(const FlowControls& c, Pack x, Pack y, Pack r, const double* constants, int i,
                            const std::int32_t* j, FlowApproach& s) {
  if (!any(r < c.guard_reach)) return;
  const Quads self = broadcast_quad(constants + 4l * i), end = load_quads(constants, j);
  const Pack overlap = larger(0.5 * c.guard_distance * (self.d + end.d) - r, Pack{});
  if (!any(overlap > Pack{})) return;
  const Pack push = 0.5 * c.guard_stiffness * (self.c + end.c) * overlap, over_r = push / r;
  s.sx -= over_r * x, s.sy -= over_r * y;
  s.energy += push * overlap;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
