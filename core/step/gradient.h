// Particle displacement gradients (VB1, VB2) in total form: L_i = sum_j V_j omega_ij (u_j - u_i) (x) xi_ij . M_i^-1.
#pragma once

#include "base/pack.h"
#include "step/lanes.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Mean stress above the tension cut-off (or the apex) opens the particle: theta^p grows at once. Handing such volume
/// to neighbours through the bonds, as dilatancy is, would pump energy into those under pressure (measured:
/// cohesionless faces blow up). in  u [n] m, plastic_volume [n]   out  L [n], dilation = tr L - theta^p [n]; sums of
/// VB5 set to zero
inline void gradient_pass(const StepData& shared, const Controls& c, const Chunk& chunk) {
  const StepData d = shared;  // its pointers stay in registers across stores
  const Pack zero{};
  for (int b = chunk.blocks_begin; b < chunk.blocks_end; ++b) {
    const Block& block = d.blocks[b];
    const int i = block.first;
    const Pack ux = load(d.ux + i), uy = load(d.uy + i);
    Pack axx = zero, axy = zero, ayx = zero, ayy = zero;
    for (int n = block.neighbours_begin; n < block.neighbours_end; ++n) {
      const NeighbourPack& neighbour = d.neighbours[n];
      const Offset& o = d.offsets[neighbour.offset];
      const Pack volume = visible(load(d.volume + neighbour.j), neighbour.lanes);
      const Pack wx = volume * (o.weight * o.xi_x), wy = volume * (o.weight * o.xi_y);
      const Pack dx = load(d.ux + neighbour.j) - ux, dy = load(d.uy + neighbour.j) - uy;
      axx += dx * wx, axy += dx * wy;
      ayx += dy * wx, ayy += dy * wy;
    }
    const Pack mxx = load(d.moment_xx + i), mxy = load(d.moment_xy + i), myy = load(d.moment_yy + i);
    const Pack lxx = axx * mxx + axy * mxy, lyy = ayx * mxy + ayy * myy;
    store(d.lxx + i, lxx);
    store(d.lxy + i, axx * mxy + axy * myy);
    store(d.lyx + i, ayx * mxx + ayy * mxy);
    store(d.lyy + i, lyy);
    Pack dilation = lxx + lyy;
    if (d.plastic_volume != nullptr) {
      const Pack opened = load(d.plastic_volume + i);
      dilation -= opened;
      if (c.dilation_cap != nullptr) {  // tension cut-off: what exceeds the cap opens the particle for good
        const Pack over = larger(dilation - load(c.dilation_cap + i), zero);
        dilation -= over;
        if (any(over > zero)) store(d.plastic_volume + i, opened + over);
      }
    }
    store(d.dilation + i, dilation);
    store(d.zxx + i, zero), store(d.zxy + i, zero), store(d.zyx + i, zero), store(d.zyy + i, zero);
    if (d.px != nullptr) store(d.px + i, zero), store(d.py + i, zero);
    if (d.volume_source != nullptr) store(d.volume_source + i, zero);
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
