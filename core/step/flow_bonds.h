// Second pass of a run-out step: hourglass virtual bonds (VB-H). A bond's traction carries what the velocity gradients
// of its two ends miss; it turns with them, fades with plastic flow and is lost where the pair parts.
#pragma once

#include "step/flow_pair_laws.h"
#include "step/flow_water.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Sums over the bonds of one particle.
struct FlowBondSums {
  Pack zxx{}, zxy{}, zyx{}, zyy{};  ///< sum B tau (x) n
  Pack fx{}, fy{}, work{};          ///< sum B tau / r, sum B tau . q dt
  Pack slope_x{}, slope_y{};        ///< sum V_j omega sigma_j xi, by component of the stress
  Pack wx{}, wy{};                  ///< sum V_j omega xi
};

/// Four bonds of particle i; tractions are for laws with such bonds:
///
///   q = (v_j - v_i)/r - Lbar n,  tau <- min(rm_i, rm_j) [turned tau + chi G dt q],
///
///   B = V_i V_j omega (1/w0_i + 1/w0_j)
template <class PairLaw, bool kDiffuse>
VBGPD_INLINE void add_bonds(const FlowData& d, const FlowControls& c, int i, std::int32_t p, FlowBondSums& s) {
  const std::int32_t* const j = d.neighbours + 4l * p;
  const double* const pair = d.pairs + 16l * p;
  const Pack wx = load(pair), wy = load(pair + 4);
  if constexpr (kDiffuse) {
    s.wx += wx, s.wy += wy;
    for (int k = 0; k < 4; ++k) {
      const Pack stress = load(d.stress + 4l * j[k]);
      s.slope_x += stress * broadcast(pair[k]), s.slope_y += stress * broadcast(pair[4 + k]);
    }
  }
  if constexpr (PairLaw::kBonds) {
    double* const record = d.traction + 8l * p;
    const Quads own = broadcast_quad(d.motion + 4l * i), other = load_quads(d.motion, j);
    const Pack x = other.a - own.a, y = other.b - own.b, weight = load(pair + 8), inverse_r = load(pair + 12);
    const Quads bond = broadcast_quad(d.bond + 4l * i), end = load_quads(d.bond, j);
    const Quads l = broadcast_quad(d.gradient + 4l * i), k = load_quads(d.gradient, j);
    const Pack bxx = (l.a + k.a) * 0.5, bxy = (l.b + k.b) * 0.5, byx = (l.c + k.c) * 0.5, byy = (l.d + k.d) * 0.5;
    const Pack qx = (other.c - own.c - bxx * x - bxy * y) * inverse_r;
    const Pack qy = (other.d - own.d - byx * x - byy * y) * inverse_r;
    const Pack angle = (byx - bxy) * (0.5 * c.time_step), cosine = 1.0 - 0.5 * angle * angle;
    const Pack ox = load(record), oy = load(record + 4);
    const Pack stiffness = (bond.c + end.c) * (0.5 * c.time_step), ratio = smaller(bond.a, end.a);
    const auto near = weight > Pack{};
    const Pack tx = select(near, ratio * (cosine * ox - angle * oy + stiffness * qx), Pack{});
    const Pack ty = select(near, ratio * (cosine * oy + angle * ox + stiffness * qy), Pack{});
    store(record, tx), store(record + 4, ty);

    const Pack share = bond.d * (bond.b + end.b), over_r = share * inverse_r, volume = share * weight;
    const Pack gx = over_r * tx, gy = over_r * ty;
    s.fx += gx * weight, s.fy += gy * weight;
    s.zxx += gx * wx, s.zxy += gx * wy, s.zyx += gy * wx, s.zyy += gy * wy;
    s.work += volume * ((tx + ox) * qx + (ty + oy) * qy);
  }
}

/// in  motion, gradient, stress, bond, slope_x (inverse moment)
///
/// in/out  traction
///
/// out  flux P = Z M^-1 / V with Z = V (sigma - p I) - sum B tau (x) n/2, pair_force, artificial, and (kDiffuse)
/// slope_x, slope_y: half the gradient of the stress among the soil
template <class PairLaw, bool kDiffuse>
inline void bond_pass(const FlowData& shared, const FlowControls& shared_controls, int first, int last,
                      FlowSums& sums) {
  const FlowData d = shared;
  const FlowControls c = shared_controls;
  for (int i = first; i < last; ++i) {
    FlowBondSums s;
    const FlowRow row = d.rows[i];
    const std::int32_t near = row.begin + static_cast<std::int32_t>(d.inverse[4l * i + 3]);
    if constexpr (PairLaw::kBonds || kDiffuse)
      for (std::int32_t p = row.begin; p < near; ++p) add_bonds<PairLaw, kDiffuse>(d, c, i, p, s);
    if constexpr (PairLaw::kBonds)
      for (auto k = 8l * near; k < 8l * row.ghosts; k += 4) store(d.traction + k, Pack{});
    const Pack z = sums_of(s.zxx, s.zxy, s.zyx, s.zyy), f = sums_of(s.fx, s.fy, s.work, Pack{});
    const double* const stress = d.stress + 4l * i;
    const double* const m = d.inverse + 4l * i;
    const double half = d.volume[i] > 0 ? 0.5 / d.volume[i] : 0;
    const double total = stress[3] - water_pressure(d, c, i);
    const double zxx = stress[0] + total - half * z[0], zxy = stress[2] - half * z[1];
    const double zyx = stress[2] - half * z[2], zyy = stress[1] + total - half * z[3];
    double* const flux = d.flux + 4l * i;
    flux[0] = zxx * m[0] + zxy * m[1], flux[1] = zxx * m[1] + zxy * m[2];
    flux[2] = zyx * m[0] + zyy * m[1], flux[3] = zyx * m[1] + zyy * m[2];
    if constexpr (PairLaw::kBonds) d.pair_force[2l * i] = f[0], d.pair_force[2l * i + 1] = f[1];
    if constexpr (PairLaw::kArtificialStress) artificial_stress(c.artificial_stress, stress, d.artificial + 4l * i);
    sums.bond += 0.25 * c.time_step * f[2];  // a bond is met from both ends; its traction before and after
    if constexpr (kDiffuse) {
      const double* const n = d.slope_x + 4l * i;
      const Pack mine = load(stress), w = sums_of(s.wx, s.wy, Pack{}, Pack{});
      const Pack sx = s.slope_x - mine * w[0], sy = s.slope_y - mine * w[1];
      const Pack along = 0.5 * (sx * n[0] + sy * n[1]), up = 0.5 * (sx * n[1] + sy * n[2]);
      store(d.slope_x + 4l * i, along), store(d.slope_y + 4l * i, up);
    }
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
