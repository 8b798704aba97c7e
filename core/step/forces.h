// Forces from virtual power (VB5), damping, and the symplectic Euler step, in one sweep over the particles.
#pragma once

#include "base/pack.h"
#include "step/neighbours.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Z_i = V_i S_i M_i^-1, so that V_i S_i Phi_ij - V_j S_j Phi_ji = omega_ij (V_j Z_i + V_i Z_j) xi_ij and Phi is never
/// stored. Also turns this step's plastic volume into plastic volumetric strain of the particle; returns the work of
/// that, with kLedger.
template <bool kLedger>
inline double flux_pass(const StepData& shared, const Chunk& chunk) {
  const StepData d = shared;
  Pack work{};
  for (int b = chunk.blocks_begin; b < chunk.blocks_end; ++b) {
    const int i = d.blocks[b].first;
    const Pack mxx = load(d.moment_xx + i), mxy = load(d.moment_xy + i), myy = load(d.moment_yy + i);
    const Pack sxx = load(d.zxx + i), sxy = load(d.zxy + i), syx = load(d.zyx + i), syy = load(d.zyy + i);
    store(d.zxx + i, sxx * mxx + sxy * mxy), store(d.zxy + i, sxx * mxy + sxy * myy);
    store(d.zyx + i, syx * mxx + syy * mxy), store(d.zyy + i, syx * mxy + syy * myy);
    if (d.volume_source == nullptr) continue;
    const Pack volume = load(d.volume + i);
    const Pack dilated = load(d.volume_source + i) / select(volume > Pack{}, volume, broadcast(1.0));
    store(d.plastic_volume + i, load(d.plastic_volume + i) + dilated);
    if constexpr (kLedger) work += dilated * load(d.mean_load + i);
  }
  return lane_sum(work);
}

/// Internal force of VB5 on the particles of a block: V_i sum_j Z_j omega_ij xi_ij + Z_i sum_j V_j omega_ij xi_ij.
template <class Sites>
VBGPD_INLINE void internal_force(const StepData& d, const Block& block, Pack& fx, Pack& fy) {
  const int i = block.first;
  const TensorSum sum = over_neighbours<Sites>(d, block, [&](TensorSum& s, int j, Pack gx, Pack gy) {
    s.xx += load(d.zxx + j) * gx, s.xy += load(d.zxy + j) * gy;
    s.yx += load(d.zyx + j) * gx, s.yy += load(d.zyy + j) * gy;
  });
  const Pack volume = load(d.volume + i), sum_x = load(d.sum_x + i), sum_y = load(d.sum_y + i);
  fx = volume * (sum.xx + sum.xy) + (load(d.zxx + i) * sum_x + load(d.zxy + i) * sum_y);
  fy = volume * (sum.yx + sum.yy) + (load(d.zyx + i) * sum_x + load(d.zyy + i) * sum_y);
  if (d.px != nullptr) fx += load(d.px + i), fy += load(d.py + i);
}

/// f = internal + external + damping; v <- b v + dt f/m; u <- u + dt v. Sums up the monitors of the chunk.
template <class Sites, bool kLedger>
inline Sums move_pass(const StepData& shared, const Controls& shared_controls, const Chunk& chunk) {
  const StepData d = shared;  // copies: their members stay in registers across stores
  const Controls c = shared_controls;
  Pack unbalanced{}, power{}, external_power{}, displacement2{}, velocity2{}, external{}, internal{}, damping{};
  for (int b = chunk.blocks_begin; b < chunk.blocks_end; ++b) {
    const Block& block = d.blocks[b];
    const int i = block.first;
    Pack ix, iy;
    internal_force<Sites>(d, block, ix, iy);
    const Pack ex = load(d.force_x + i), ey = load(d.force_y + i);
    const Pack free_x = load(d.free_x + i), free_y = load(d.free_y + i);
    const Pack fx = (ix + ex) * free_x, fy = (iy + ey) * free_y;
    const Pack vx = load(d.vx + i), vy = load(d.vy + i);
    unbalanced += magnitude(fx) + magnitude(fy);
    power += fx * vx + fy * vy;
    external_power += ex * vx + ey * vy;
    // local damping (FLAC): f_d = -alpha |f| sgn v
    const Pack zero{};
    const Pack dx = -c.local_damping * magnitude(fx) *
                    (select(vx > zero, broadcast(1.0), zero) - select(vx < zero, broadcast(1.0), zero));
    const Pack dy = -c.local_damping * magnitude(fy) *
                    (select(vy > zero, broadcast(1.0), zero) - select(vy < zero, broadcast(1.0), zero));
    const Pack mass = load(c.mass + i);  // 0 in padding and without a neighbour: stays
    const auto there = mass > zero;
    const Pack kick = select(there, c.kick * (1.0 / select(there, mass, broadcast(1.0))), zero);
    const Pack nx = c.momentum * vx + kick * (fx + dx), ny = c.momentum * vy + kick * (fy + dy);
    const Pack ux = load(d.ux + i) + c.time_step * nx, uy = load(d.uy + i) + c.time_step * ny;
    store(d.vx + i, nx), store(d.vy + i, ny);
    store(d.ux + i, ux), store(d.uy + i, uy);
    displacement2 = larger(displacement2, ux * ux + uy * uy);
    velocity2 = larger(velocity2, nx * nx + ny * ny);
    if constexpr (kLedger) {
      const Pack mx = 0.5 * c.time_step * (vx + nx), my = 0.5 * c.time_step * (vy + ny);
      external += ex * mx + ey * my, internal += ix * mx + iy * my, damping += dx * mx + dy * my;
    }
  }
  return {lane_sum(unbalanced),    lane_sum(power),     lane_sum(external_power),
          lane_max(displacement2), lane_max(velocity2), lane_sum(external),
          lane_sum(internal),      lane_sum(damping),   0};
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
