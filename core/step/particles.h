// No bonds: stress and yielding at the particle, corrected nodal SPH. The rival the bonds are measured against.
#pragma once

#include "base/pack.h"
#include "material/cone.h"
#include "material/hexagon.h"
#include "step/lanes.h"
#include "step/ledger.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// One pack of particles of one material: trial stress in total form, return, V_i S_i = V_i sigma_i.
template <template <class> class Law, bool kLedger>
VBGPD_INLINE double particle_stress(const StepData& d, const Controls& controls, const LawConstants& constants, int i,
                                    std::uint8_t lanes) {
  Law<Pack> law(constants);
  if (d.extra_cohesion != nullptr)
    law.k += load(d.extra_cohesion + i) * (controls.cohesion_scale * constants.k_per_cohesion);
  const Pack exx = load(d.lxx + i), eyy = load(d.lyy + i), exy = (load(d.lxy + i) + load(d.lyx + i)) * 0.5;
  const Pack third = (exx + eyy) * (1.0 / 3.0);
  const double twice_shear = 2.0 * law.shear;
  const double* const record = d.plastic_strain == nullptr ? nullptr : d.plastic_strain + 3l * i;
  Pack pxx{}, pyy{}, pxy{};
  if (record != nullptr) pxx = load(record), pyy = load(record + kWidth), pxy = load(record + 2 * kWidth);
  const Stress<Pack> trial{twice_shear * (exx - third - pxx), twice_shear * (eyy - third - pyy),
                           twice_shear * (exy - pxy), law.bulk * load(d.dilation + i)};
  const Returned<Pack> r = return_to(law, trial);
  const Stress<Pack>& s = r.stress;
  const Pack volume = visible(load(d.volume + i), lanes);
  double plastic_work = 0;
  if (r.any && record != nullptr) {
    const Pack compliance = select(volume > Pack{}, broadcast(1.0) / twice_shear, Pack{});
    const Pack dxx = (trial.xx - s.xx) * compliance, dyy = (trial.yy - s.yy) * compliance,
               dxy = (trial.xy - s.xy) * compliance;
    if (d.plastic_strain_to != nullptr) {
      double* const to = d.plastic_strain_to + 3l * i;
      store(to, pxx + dxx), store(to + kWidth, pyy + dyy), store(to + 2 * kWidth, pxy + dxy);
    }
    const Pack dilated = r.dilated;
    if (d.volume_source != nullptr) store(d.volume_source + i, load(d.volume_source + i) + volume * dilated);
    if constexpr (kLedger) plastic_work = lane_sum(volume * shear_work(s, dxx, dyy, dxy));
  }
  if constexpr (kLedger)
    if (d.opening != nullptr) {
      plastic_work += lane_sum(volume * load(d.opening + i) * s.m);
      if (d.mean_load != nullptr) store(d.mean_load + i, load(d.mean_load + i) + volume * s.m);
    }
  store(d.zxx + i, load(d.zxx + i) + volume * (s.xx + s.m)), store(d.zxy + i, load(d.zxy + i) + volume * s.xy);
  store(d.zyx + i, load(d.zyx + i) + volume * s.xy), store(d.zyy + i, load(d.zyy + i) + volume * (s.yy + s.m));
  return plastic_work;
}

/// All particles of a chunk; the packs of the chunk say which lanes have which material (pack.i == pack.j == first
/// particle).
template <template <class> class Law, bool kLedger>
inline double particle_pass(const StepData& d, const Controls& controls, const Chunk& chunk) {
  constexpr int algorithm = Law<Pack>::kAlgorithm;
  double plastic_work = 0;
  for (int p = chunk.packs_begin[algorithm]; p < chunk.packs_end[algorithm]; ++p) {
    const BondPack& pack = d.packs[p];
    plastic_work += particle_stress<Law, kLedger>(d, controls, controls.constants[pack.pair], pack.i, pack.lanes);
  }
  return plastic_work;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
