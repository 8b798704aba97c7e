// Virtual bonds, selective form (VB-S): deviator and yielding at the bond, volume at the particle (VB2-VB5).
#pragma once

#include "base/pack.h"
#include "material/cone.h"
#include "material/hexagon.h"
#include "step/lanes.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// One pack of bonds while it is worked on.
struct BondStrain {
  Pack xx, yy, xy;  ///< sym L_ij, in-plane part
};

/// VB2: L_ij = Lbar + (du/r - Lbar n) (x) n stretches the bond exactly; its symmetric part.
VBGPD_INLINE BondStrain bond_strain(const StepData& d, const Offset& o, int i, int j) {
  const Pack bxx = (load(d.lxx + i) + load(d.lxx + j)) * 0.5, bxy = (load(d.lxy + i) + load(d.lxy + j)) * 0.5;
  const Pack byx = (load(d.lyx + i) + load(d.lyx + j)) * 0.5, byy = (load(d.lyy + i) + load(d.lyy + j)) * 0.5;
  const Pack cx = load(d.ux + j) - load(d.ux + i) - bxx * o.xi_x - bxy * o.xi_y;
  const Pack cy = load(d.uy + j) - load(d.uy + i) - byx * o.xi_x - byy * o.xi_y;
  const double nx = o.xi_x * o.inverse_r2, ny = o.xi_y * o.inverse_r2;
  return {bxx + cx * nx, byy + cy * ny, (bxy + byx + cx * ny + cy * nx) * 0.5};
}

/// Cohesion that grows with depth is added to the strength of the pair.
template <class LawOnPacks>
VBGPD_INLINE void add_cohesion(LawOnPacks& law, const StepData& d, const Controls& controls, const LawConstants& c,
                               int i, int j) {
  const Pack extra =
      (load(d.extra_cohesion + i) + load(d.extra_cohesion + j)) * (0.5 * controls.cohesion_scale * c.k_per_cohesion);
  law.k += extra;
}

/// Sums over the bonds of one particle pack.
struct BondSums {
  Pack zxx{}, zxy{}, zyx{}, zyy{};  ///< V_i S_i
  Pack fx{}, fy{};                  ///< sum of B_ij s_ij n_ij / r
  Pack source{};                    ///< volume that turned plastic
};

/// Adds the sums of a pack of bonds to the particles from `first` on; the pair force with the sign of the end.
VBGPD_INLINE void add_sums(const StepData& d, int first, const BondSums& s, double sign) {
  store(d.zxx + first, load(d.zxx + first) + s.zxx), store(d.zxy + first, load(d.zxy + first) + s.zxy);
  store(d.zyx + first, load(d.zyx + first) + s.zyx), store(d.zyy + first, load(d.zyy + first) + s.zyy);
  store(d.px + first, load(d.px + first) + sign * s.fx), store(d.py + first, load(d.py + first) + sign * s.fy);
}

VBGPD_INLINE void add_source(const StepData& d, int first, Pack source) {
  store(d.volume_source + first, load(d.volume_source + first) + source);
}

/// One pack of bonds: VB3-VB5. Returns its sums; plastic strain is updated in place, plastic work booked where asked.
template <template <class> class Law, bool kLedger>
VBGPD_INLINE BondSums bond_pack(const StepData& d, const Controls& controls, const BondPack& pack,
                                double& plastic_work) {
  const Offset& o = d.offsets[pack.offset];
  const int i = pack.i, j = pack.j;
  const LawConstants& constants = controls.constants[pack.pair];
  Law<Pack> law(constants);
  if (d.extra_cohesion != nullptr) add_cohesion(law, d, controls, constants, i, j);

  // VB3, VB4: trial stress in total form, returned to the yield surface
  const BondStrain e = bond_strain(d, o, i, j);
  const Pack third = (e.xx + e.yy) * (1.0 / 3.0);
  const double twice_shear = 2.0 * law.shear;
  double* const record = d.plastic_strain == nullptr ? nullptr : d.plastic_strain + 3l * kWidth * pack.slot;
  Pack pxx{}, pyy{}, pxy{};
  if (record != nullptr) pxx = load(record), pyy = load(record + kWidth), pxy = load(record + 2 * kWidth);
  const Stress<Pack> trial{twice_shear * (e.xx - third - pxx), twice_shear * (e.yy - third - pyy),
                           twice_shear * (e.xy - pxy),
                           (0.5 * law.bulk) * (load(d.dilation + i) + load(d.dilation + j))};
  const Returned<Pack> r = law.returned(trial);
  const Stress<Pack>& s = r.stress;

  // B_ij = 2 V_i V_j w~_ij = omega_ij V_i V_j (1/omega0_i + 1/omega0_j)
  Pack bond_volume = (load(d.volume + i) * load(d.share + j) + load(d.share + i) * load(d.volume + j)) * o.weight;
  bond_volume = visible(bond_volume, pack.lanes);
  const Pack half = bond_volume * 0.5;

  BondSums sums;
  if (r.any && record != nullptr) {  // elastic bonds write nothing
    const Pack compliance = select(half > Pack{}, Pack{} + 1.0 / twice_shear, Pack{});
    const Pack dxx = (trial.xx - s.xx) * compliance, dyy = (trial.yy - s.yy) * compliance,
               dxy = (trial.xy - s.xy) * compliance;
    store(record, pxx + dxx), store(record + kWidth, pyy + dyy), store(record + 2 * kWidth, pxy + dxy);
    if (law.b > 0) sums.source = half * r.dilated;
    if constexpr (kLedger)
      plastic_work += lane_sum(
          bond_volume * (s.xx * (2.0 * dxx + dyy) + s.yy * (2.0 * dyy + dxx) + 2.0 * s.xy * dxy + s.m * r.dilated));
  }

  // VB5: V_i S_i = sum_j B_ij/2 [ s (I - n n^T) + m I ],  pair force B_ij s n / r
  const Pack tx = s.xx * o.xi_x + s.xy * o.xi_y, ty = s.xy * o.xi_x + s.yy * o.xi_y;
  const double nx = o.xi_x * o.inverse_r2, ny = o.xi_y * o.inverse_r2;
  sums.zxx = half * (s.xx - tx * nx + s.m), sums.zxy = half * (s.xy - tx * ny);
  sums.zyx = half * (s.xy - ty * nx), sums.zyy = half * (s.yy - ty * ny + s.m);
  sums.fx = bond_volume * tx * o.inverse_r2, sums.fy = bond_volume * ty * o.inverse_r2;
  return sums;
}

/// All packs of one return algorithm in a chunk.
/// in  u, L, dilation   in/out  plastic_strain   out  V_i S_i (added), pair force (added), volume_source (added)
/// Returns the plastic work of this step where the ledger is kept. Linear momentum is exact: every pair force has its
/// opposite.
template <template <class> class Law, bool kLedger>
inline double bond_pass(const StepData& shared, const Controls& controls, const Chunk& chunk) {
  const StepData d = shared;  // a copy nobody else can see: its pointers stay in registers across stores
  constexpr int algorithm = Law<Pack>::kAlgorithm;
  double plastic_work = 0;
  const bool sourced = d.volume_source != nullptr;
  const int end = chunk.packs_end[algorithm];
  for (int p = chunk.packs_begin[algorithm]; p < end;) {
    // the bonds of one block share their first end: its sums stay in registers
    const int i = d.packs[p].i;
    BondSums own;
    for (; p < end && d.packs[p].i == i; ++p) {
      const BondPack& pack = d.packs[p];
      const BondSums s = bond_pack<Law, kLedger>(d, controls, pack, plastic_work);
      own.zxx += s.zxx, own.zxy += s.zxy, own.zyx += s.zyx, own.zyy += s.zyy, own.fx += s.fx, own.fy += s.fy;
      add_sums(d, pack.j, s, -1);
      if (sourced && controls.constants[pack.pair].b > 0) own.source += s.source, add_source(d, pack.j, s.source);
    }
    add_sums(d, i, own, 1);
    if (sourced) add_source(d, i, own.source);
  }
  return plastic_work;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
