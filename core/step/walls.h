// Walls that move or slide. Fixed walls need nothing: they are not free.
#pragma once

#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Prescribed walls move with their velocity; rollers lose the velocity across the wall (u follows in the same
/// proportion).
inline void guide_walls(const StepData& d, const Controls& c) {
  for (int n = 0; n < d.guided_count; ++n) {
    const GuidedParticle& g = d.guided[n];
    const int i = g.particle;
    if (g.prescribed != 0) {
      d.ux[i] += c.time_step * (g.x - d.vx[i]), d.uy[i] += c.time_step * (g.y - d.vy[i]);
      d.vx[i] = g.x, d.vy[i] = g.y;
    } else {
      const double across = d.vx[i] * g.x + d.vy[i] * g.y;
      d.ux[i] -= c.time_step * across * g.x, d.uy[i] -= c.time_step * across * g.y;
      d.vx[i] -= across * g.x, d.vy[i] -= across * g.y;
    }
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
