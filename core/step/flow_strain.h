// First pass of a run-out step: operators and velocity gradient at the present positions, then the stress.
#pragma once

#include "step/flow_pair_laws.h"
#include "step/flow_stress.h"
#include "step/flow_weight.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

inline constexpr double kJustBelowOne = 1 - 0x1p-53;

/// M_i = sum_j V_j omega_ij xi xi^T, L_i = [sum_j V_j omega_ij (v_j - v_i) (x) xi] M_i^-1; mirror images take part.
/// in  motion (ghosts too)   in/out  stress, gap, plastic_strain, dead, springs (traction)   out  gradient, inverse,
/// bond
template <class PairLaw>
inline void strain_pass(const FlowData& shared, const FlowControls& shared_controls, int first, int last,
                        FlowSums& sums) {
  const FlowData d = shared;  // copies: their members stay in registers across stores
  const FlowControls c = shared_controls;
  for (int i = first; i < last; ++i) {
    const Quads own = broadcast_quad(d.motion + 4l * i);
    Pack mxx{}, mxy{}, myy{}, total{}, axx{}, axy{}, ayx{}, ayy{};
    for (std::int32_t p = d.rows[i].begin; p < d.rows[i].end; ++p) {
      const std::int32_t* const j = d.neighbours + 4l * p;
      const Quads other = load_quads(d.motion, j);
      const Pack x = other.a - own.a, y = other.b - own.b;
      const Pack r = root(x * x + y * y);
      Pack weight = pair_weight(c, r) * load_each(d.volume, j);
      if constexpr (PairLaw::kSprings) {
        if (p < d.rows[i].ghosts) {
          const double own_stretch = c.laws[d.soil[i]].breaking_stretch;
          const auto bears = [&](int k) {
            return j[k] < d.particles ? smaller(own_stretch, c.laws[d.soil[j[k]]].breaking_stretch) : own_stretch;
          };
          const Pack breaking{bears(0), bears(1), bears(2), bears(3)};
          weight = select(stretch_springs(d.traction + 8l * p, r, breaking), weight, Pack{});
        } else {
          weight = select(r < c.spring_reach, weight, Pack{});
        }
      }
      const Pack wx = weight * x, wy = weight * y, vx = other.c - own.c, vy = other.d - own.d;
      total += weight;
      mxx += wx * x, mxy += wx * y, myy += wy * y;
      axx += vx * wx, axy += vx * wy, ayx += vy * wx, ayy += vy * wy;
    }
    const Pack m = sums_of(mxx, mxy, myy, total), a = sums_of(axx, axy, ayx, ayy);
    Inverse inverse{1, 0, 1};
    if constexpr (PairLaw::kCorrected) inverse = floored_inverse(m[0], m[1], m[2], c.smallest_eigenvalue);
    double* const l = d.gradient + 4l * i;
    l[0] = a[0] * inverse.xx + a[1] * inverse.xy, l[1] = a[0] * inverse.xy + a[1] * inverse.yy;
    l[2] = a[2] * inverse.xx + a[3] * inverse.xy, l[3] = a[2] * inverse.xy + a[3] * inverse.yy;
    double* const stored = d.inverse + 4l * i;
    stored[0] = inverse.xx, stored[1] = inverse.xy, stored[2] = inverse.yy;

    const FlowLaw& law = c.laws[d.soil[i]];
    const double extra = d.extra_cohesion == nullptr ? 0 : d.extra_cohesion[i] * c.cohesion_scale;
    double* const dead = PairLaw::kDies ? d.dead + i : nullptr;
    const StressUpdate update =
        update_stress<PairLaw>(law, extra, c.time_step, l, d.stress + 4l * i, d.gap[i], d.plastic_strain[i], dead);
    const double volume = d.volume[i];
    // stress diffuses where this is below one: in soil that yields, and in disturbed soil on its way to rest, whose
    // noise would freeze in (measured: 2 % of gamma H instead of 0.4 %); soil that never moved is left as it is
    const bool disturbed = d.plastic_strain[i] > c.disturbed;
    d.bond[4l * i] = disturbed ? smaller(update.return_ratio, kJustBelowOne) : update.return_ratio;
    d.bond[4l * i + 1] = m[3] > 0 ? 1 / m[3] : 0;
    sums.internal += volume * update.work;
    if (update.return_ratio < 1) sums.yielding += volume;
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
