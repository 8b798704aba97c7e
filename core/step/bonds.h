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
VBGPD_INLINE void add_cohesion(LawOnPacks& law, const StepData& d, const Controls& controls, const LawConstants& c, int i, int j) {
  const Pack extra = (load(d.extra_cohesion + i) + load(d.extra_cohesion + j)) * (0.5 * controls.cohesion_scale * c.k_per_cohesion);
  law.k += extra;
}

/// VB3-VB5 over the packs of one return algorithm in a chunk.
/// in  u, L, dilation   in/out  plastic_strain   out  V_i S_i (added), pair force (added), volume_source (added)
/// Returns the plastic work of this step where the ledger is kept. Linear momentum is exact: every pair force has its opposite.
template <template <class> class Law, bool kLedger>
inline double bond_pass(const StepData& d, const Controls& controls, const Chunk& chunk) {
  constexpr int algorithm = Law<Pack>::kAlgorithm;
  double plastic_work = 0;
  for (int p = chunk.packs_begin[algorithm]; p < chunk.packs_end[algorithm]; ++p) {
    const BondPack& pack = d.packs[p];
    const Offset& o = d.offsets[pack.offset];
    const int i = pack.i, j = pack.j;
    const LawConstants& constants = controls.constants[pack.pair];
    Law<Pack> law(constants);
    if (d.extra_cohesion != nullptr) add_cohesion(law, d, controls, constants, i, j);

    // VB3, VB4: trial stress in total form, returned to the yield surface
    const BondStrain e = bond_strain(d, o, i, j);
    const Pack third = (e.xx + e.yy) * (1.0 / 3.0), twice_shear = law.shear * 2.0;
    double* const record = d.plastic_strain == nullptr ? nullptr : d.plastic_strain + 3l * kWidth * pack.slot;
    Pack pxx{}, pyy{}, pxy{};
    if (record != nullptr) pxx = load(record), pyy = load(record + kWidth), pxy = load(record + 2 * kWidth);
    const Stress<Pack> trial{twice_shear * (e.xx - third - pxx), twice_shear * (e.yy - third - pyy), twice_shear * (e.xy - pxy),
                             law.bulk * 0.5 * (load(d.dilation + i) + load(d.dilation + j))};
    const Returned<Pack> r = law.returned(trial);
    const Stress<Pack>& s = r.stress;

    // B_ij = 2 V_i V_j w~_ij = omega_ij V_i V_j (1/omega0_i + 1/omega0_j)
    Pack bond_volume = (load(d.volume + i) * load(d.share + j) + load(d.share + i) * load(d.volume + j)) * o.weight;
    bond_volume = visible(bond_volume, pack.lanes);
    const Pack half = bond_volume * 0.5;

    if (r.any && record != nullptr) {  // elastic bonds write nothing
      const Pack shown = half > Pack{} ? Pack{} + 1.0 : Pack{};
      const Pack compliance = shown / twice_shear;
      const Pack dxx = (trial.xx - s.xx) * compliance, dyy = (trial.yy - s.yy) * compliance, dxy = (trial.xy - s.xy) * compliance;
      store(record, pxx + dxx), store(record + kWidth, pyy + dyy), store(record + 2 * kWidth, pxy + dxy);
      const Pack dilated = r.dilated;
      if (d.volume_source != nullptr && any(dilated * half != Pack{})) {
        store(d.volume_source + i, load(d.volume_source + i) + half * dilated);
        store(d.volume_source + j, load(d.volume_source + j) + half * dilated);
      }
      if constexpr (kLedger)
        plastic_work += lane_sum(bond_volume * (s.xx * (2.0 * dxx + dyy) + s.yy * (2.0 * dyy + dxx) + 2.0 * s.xy * dxy + s.m * dilated));
    }

    // VB5: V_i S_i = sum_j B_ij/2 [ s (I - n n^T) + m I ],  pair force B_ij s n / r
    const Pack tx = s.xx * o.xi_x + s.xy * o.xi_y, ty = s.xy * o.xi_x + s.yy * o.xi_y;
    const double nx = o.xi_x * o.inverse_r2, ny = o.xi_y * o.inverse_r2;
    const Pack zxx = half * (s.xx - tx * nx + s.m), zxy = half * (s.xy - tx * ny);
    const Pack zyx = half * (s.xy - ty * nx), zyy = half * (s.yy - ty * ny + s.m);
    const Pack fx = bond_volume * tx * o.inverse_r2, fy = bond_volume * ty * o.inverse_r2;
    store(d.zxx + i, load(d.zxx + i) + zxx), store(d.zxy + i, load(d.zxy + i) + zxy);
    store(d.zyx + i, load(d.zyx + i) + zyx), store(d.zyy + i, load(d.zyy + i) + zyy);
    store(d.px + i, load(d.px + i) + fx), store(d.py + i, load(d.py + i) + fy);
    store(d.zxx + j, load(d.zxx + j) + zxx), store(d.zxy + j, load(d.zxy + j) + zxy);
    store(d.zyx + j, load(d.zyx + j) + zyx), store(d.zyy + j, load(d.zyy + j) + zyy);
    store(d.px + j, load(d.px + j) - fx), store(d.py + j, load(d.py + j) - fy);
  }
  return plastic_work;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
