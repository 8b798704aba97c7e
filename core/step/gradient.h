// Particle displacement gradients (VB1, VB2) in total form: L_i = sum_j V_j omega_ij (u_j - u_i) (x) xi_ij . M_i^-1,
// summed as sum_j (V_j u_j) (x) omega_ij xi_ij - u_i (x) sum_j V_j omega_ij xi_ij, whose last factor never changes.
#pragma once

#include "base/pack.h"
#include "step/neighbours.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// V_i u_i, which all sums over neighbours share.
inline void weigh_pass(const StepData& shared, const Chunk& chunk) {
  const StepData d = shared;
  for (int b = chunk.blocks_begin; b < chunk.blocks_end; ++b) {
    const int i = d.blocks[b].first;
    const Pack volume = load(d.volume + i);
    store(d.weighted_x + i, volume * load(d.ux + i)), store(d.weighted_y + i, volume * load(d.uy + i));
  }
}

/// Mean stress above the tension cut-off (or the apex) opens the particle by what exceeds the cap. In a relaxation,
/// whose vibrations mean nothing, a gap closes where it opened: kept, it would push the soil apart, crack by crack
/// (measured: slopes without tension come to no verdict). In true dynamics it is kept as plastic volume: bonds give
/// back other work than they took where their other end has changed (measured: an impact gains energy). Handing such
/// volume to neighbours through the bonds, as dilatancy is, would pump energy into those under pressure (measured:
/// cohesionless faces blow up). With kLedger by how much it opened in this step is kept for the books.
///
/// in  u [n] m, plastic_volume [n]
///
/// out  L [n], gap [n], dilation = tr L - theta^p - gap [n]; sums of VB5 set to zero
template <class Sites, bool kLedger>
inline void gradient_pass(const StepData& shared, const Controls& c, const Chunk& chunk) {
  const StepData d = shared;  // its pointers stay in registers across stores
  const Pack zero{};
  for (int b = chunk.blocks_begin; b < chunk.blocks_end; ++b) {
    const Block& block = d.blocks[b];
    const int i = block.first;
    const TensorSum sum = over_neighbours<Sites>(d, block, [&](TensorSum& s, int j, Pack gx, Pack gy) {
      const Pack wx = load(d.weighted_x + j), wy = load(d.weighted_y + j);
      s.xx += wx * gx, s.xy += wx * gy;
      s.yx += wy * gx, s.yy += wy * gy;
    });
    const Pack ux = load(d.ux + i), uy = load(d.uy + i), sum_x = load(d.sum_x + i), sum_y = load(d.sum_y + i);
    const Pack axx = sum.xx - ux * sum_x, axy = sum.xy - ux * sum_y;
    const Pack ayx = sum.yx - uy * sum_x, ayy = sum.yy - uy * sum_y;
    const Pack mxx = load(d.moment_xx + i), mxy = load(d.moment_xy + i), myy = load(d.moment_yy + i);
    const Pack lxx = axx * mxx + axy * mxy, lyy = ayx * mxy + ayy * myy;
    store(d.lxx + i, lxx);
    store(d.lxy + i, axx * mxy + axy * myy);
    store(d.lyx + i, ayx * mxx + ayy * mxy);
    store(d.lyy + i, lyy);
    Pack dilation = lxx + lyy;
    if (d.plastic_volume != nullptr) {
      const Pack plastic = load(d.plastic_volume + i);
      dilation -= plastic;
      if (c.dilation_cap != nullptr) {
        const Pack gap = larger(dilation - load(c.dilation_cap + i), zero);
        dilation -= gap;
        if constexpr (kLedger) store(d.opening + i, gap - load(d.gap + i));
        if (c.keeps_gaps) store(d.plastic_volume + i, plastic + gap), store(d.gap + i, zero);
        else store(d.gap + i, gap);
      }
    }
    store(d.dilation + i, dilation);
    store(d.zxx + i, zero), store(d.zxy + i, zero), store(d.zyx + i, zero), store(d.zyy + i, zero);
    if (d.px != nullptr) store(d.px + i, zero), store(d.py + i, zero);
    if (d.volume_source != nullptr) store(d.volume_source + i, zero);
    if constexpr (kLedger)
      if (d.mean_load != nullptr) store(d.mean_load + i, zero);
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
