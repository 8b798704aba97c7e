// Virtual bonds, selective form (VB-S): deviator and yielding at the bond, volume at the particle (VB2-VB5).
#pragma once

#include "base/pack.h"
#include "material/cone.h"
#include "material/hexagon.h"
#include "step/ledger.h"
#include "step/sites.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// What a bond needs of one of its ends: displacement and its gradient, elastic dilation, volume, V / omega0.
struct BondEnd {
  Pack ux, uy, lxx, lxy, lyx, lyy, dilation, volume, share;
};
VBGPD_INLINE BondEnd bond_end(const StepData& d, int i) {
  return {load(d.ux + i),  load(d.uy + i),       load(d.lxx + i),    load(d.lxy + i),  load(d.lyx + i),
          load(d.lyy + i), load(d.dilation + i), load(d.volume + i), load(d.share + i)};
}

/// Twice the bond strain (VB2), engineering shear: L_ij = Lbar + (du/r - Lbar n) (x) n stretches the bond exactly.
struct BondStrain {
  Pack xx, yy, xy;  ///< 2 e_xx, 2 e_yy, 4 e_xy
};
template <class Bond>
VBGPD_INLINE BondStrain twice_bond_strain(const BondEnd& a, const StepData& d, int j, const Bond& o) {
  const Pack sxx = a.lxx + load(d.lxx + j), sxy = a.lxy + load(d.lxy + j);
  const Pack syx = a.lyx + load(d.lyx + j), syy = a.lyy + load(d.lyy + j);
  const Pack dx = load(d.ux + j) - a.ux, dy = load(d.uy + j) - a.uy;
  const Pack cx = dx - sxx * o->half_x - sxy * o->half_y;
  const Pack cy = dy - syx * o->half_x - syy * o->half_y;
  return {sxx + cx * o->twice_n_x, syy + cy * o->twice_n_y, (sxy + syx) + cx * o->twice_n_y + cy * o->twice_n_x};
}

/// A pack of bonds while it is worked on: stress, first trial, then returned, then times half the bond volume.
template <class Sites>
struct BondWork {
  typename Sites::Bond bond;
  Stress<Pack> stress;
  Pack half;    ///< B_ij/2 = V_i V_j w~_ij; 0 where a lane is no bond
  Pack source;  ///< plastic dilation times B_ij/2
};

/// Strength of a bond: cohesion that grows with depth is added to that of the pair.
template <class LawOnPacks>
VBGPD_INLINE Pack strength_of(const LawOnPacks& law, const StepData& d, const Controls& controls, const LawConstants& c,
                              int i, int j) {
  if (d.extra_cohesion == nullptr) return law.k;
  return law.k +
         (load(d.extra_cohesion + i) + load(d.extra_cohesion + j)) * (0.5 * controls.cohesion_scale * c.k_per_cohesion);
}

/// Records follow each other in the order of the packs, in and out of cache by far more than one batch: those of the
/// batch after next are asked for.
VBGPD_INLINE void fetch_ahead(const double* record) {
  constexpr int kRecords = 24;
  const double* const ahead = record + 3l * kWidth * kRecords;
  for (int line = 0; line < 3 * kWidth; line += 8) __builtin_prefetch(ahead + line, 1);
}

/// VB3: trial stress in total form, from the strain that is not plastic.
template <class Sites, class LawOnPacks>
VBGPD_INLINE void trial_stress(const StepData& d, const BondEnd& a, const BondPack& pack, const LawOnPacks& law,
                               BondWork<Sites>& w) {
  w.bond = Sites::bond(d, pack);
  const int j = pack.j;
  const BondStrain e = twice_bond_strain(a, d, j, w.bond);
  const double shear = law.shear, third = shear / 3;
  Stress<Pack> s{2 * third * e.xx - third * e.yy, 2 * third * e.yy - third * e.xx, 0.5 * shear * e.xy,
                 (0.5 * law.bulk) * (a.dilation + load(d.dilation + j))};
  if (d.plastic_strain != nullptr) {
    const double* const record = d.plastic_strain + 3l * kWidth * pack.slot;
    fetch_ahead(record);
    s.xx -= 2 * shear * load(record), s.yy -= 2 * shear * load(record + kWidth);
    s.xy -= 2 * shear * load(record + 2 * kWidth);
  }
  w.stress = s;
  // B_ij/2 = omega_ij V_i V_j (1/omega0_i + 1/omega0_j) / 2
  const Pack half = (a.volume * load(d.share + j) + a.share * load(d.volume + j)) * w.bond->half_weight;
  w.half = visible(half, pack.lanes);
}

/// VB4: return to the yield surface, where the look at the trial stress says so; plastic strain is updated in place,
/// elastic bonds write nothing.
template <bool kLedger, class Sites, class LawOnPacks>
VBGPD_INLINE void return_stress(const StepData& d, const BondPack& pack, const LawOnPacks& law, double compliance,
                                const typename LawOnPacks::Look& looked, Pack strength, BondWork<Sites>& w,
                                double& plastic_work) {
  const Pack half = w.half;
  w.source = Pack{};
  if (any(looked.yields)) {
    const Stress<Pack> trial = w.stress;
    const Returned<Pack> r = law.returned(trial, looked, strength);
    const Stress<Pack>& s = r.stress;
    w.stress = s;
    const Pack there = select(half > Pack{}, broadcast(compliance), Pack{});
    const Pack dxx = (trial.xx - s.xx) * there, dyy = (trial.yy - s.yy) * there, dxy = (trial.xy - s.xy) * there;
    if (d.plastic_strain_to != nullptr) {
      double* const record = d.plastic_strain_to + 3l * kWidth * pack.slot;
      store(record, load(record) + dxx), store(record + kWidth, load(record + kWidth) + dyy);
      store(record + 2 * kWidth, load(record + 2 * kWidth) + dxy);
    }
    w.source = half * r.dilated;
    if constexpr (kLedger) plastic_work += 2 * lane_sum(half * shear_work(s, dxx, dyy, dxy));
  }
  if constexpr (kLedger)
    if (d.opening != nullptr) plastic_work += lane_sum(opening_work(d, pack, half, w.stress.m));
  w.stress = {half * w.stress.xx, half * w.stress.yy, half * w.stress.xy, half * w.stress.m};
}

/// VB5: V_i S_i = sum_j B_ij/2 [ s (I - n n^T) + m I ] of both ends, pair force B_ij s n / r with opposite signs.
template <class Sites>
VBGPD_INLINE void add_loads(const StepData& d, int i, const BondPack* packs, const BondWork<Sites>* loads, int count,
                            bool sourced, double bulk) {
  Pack zxx{}, zxy{}, zyx{}, zyy{}, px{}, py{};  // added at the end: both ends may share particles
  for (int p = 0; p < count; ++p) {
    const auto& o = loads[p].bond;
    const Stress<Pack>& s = loads[p].stress;
    const int j = packs[p].j;
    const Pack tx = s.xx * o->half_x + s.xy * o->half_y, ty = s.xy * o->half_x + s.yy * o->half_y;
    const Pack sxx = (s.xx + s.m) - tx * o->twice_n_x, sxy = s.xy - tx * o->twice_n_y;
    const Pack syx = s.xy - ty * o->twice_n_x, syy = (s.yy + s.m) - ty * o->twice_n_y;
    const Pack fx = tx * o->pull, fy = ty * o->pull;
    zxx += sxx, zxy += sxy, zyx += syx, zyy += syy, px += fx, py += fy;
    add(d.zxx + j, sxx), add(d.zxy + j, sxy), add(d.zyx + j, syx), add(d.zyy + j, syy);
    add(d.px + j, -fx), add(d.py + j, -fy);
  }
  add(d.zxx + i, zxx), add(d.zxy + i, zxy), add(d.zyx + i, zyx), add(d.zyy + i, zyy);
  add(d.px + i, px), add(d.py + i, py);
  if (!sourced) return;
  Pack own{};
  for (int p = 0; p < count; ++p) {
    const int j = packs[p].j;
    if (d.compressibility == nullptr) {
      own += loads[p].source, add(d.volume_source + j, loads[p].source);
      continue;
    }
    // springs in series: the mean stress of either end falls by what the return took off that of the bond
    const Pack dilated = bulk * loads[p].source;
    own += dilated * load(d.compressibility + i);
    add(d.volume_source + j, dilated * load(d.compressibility + j));
  }
  add(d.volume_source + i, own);
}

template <class Sites, template <class> class Law, bool kLedger>
inline double bond_pass(const StepData& shared, const Controls& shared_controls, const Chunk& chunk) {
  const StepData d = shared;  // a copy nobody else can see: its pointers stay in registers across stores
  const Controls controls = shared_controls;
  constexpr int algorithm = Law<Pack>::kAlgorithm;
  constexpr int kMost = 16;
  double plastic_work = 0;
  const int end = chunk.packs_end[algorithm];
  BondWork<Sites> work[kMost];
  typename Law<Pack>::Look looks[kMost];
  for (int p = chunk.packs_begin[algorithm]; p < end;) {
    const std::int32_t pair = d.packs[p].pair;  // of materials: most sections have one
    const LawConstants constants = controls.constants[pair];
    const double compliance = 0.5 / constants.shear_modulus;
    const Law<Pack> law(constants);
    const bool sourced = d.volume_source != nullptr && law.b > 0;  // isochoric flow is no source
    while (p < end && d.packs[p].pair == pair) {
      const BondPack* const batch = d.packs + p;  // bonds of one block, sharing their first end
      int count = 1;
      while (p + count < end && batch[count].i == batch->i && batch[count].pair == pair && count < kMost) ++count;
      const BondEnd a = bond_end(d, batch->i);
      for (int n = 0; n < count; ++n) {
        trial_stress(d, a, batch[n], law, work[n]);
        looks[n] = law.look(work[n].stress, strength_of(law, d, controls, constants, batch->i, batch[n].j));
      }
      for (int n = 0; n < count; ++n)
        return_stress<kLedger>(d, batch[n], law, compliance, looks[n],
                               strength_of(law, d, controls, constants, batch->i, batch[n].j), work[n], plastic_work);
      add_loads(d, batch->i, batch, work, count, sourced, constants.bulk_modulus);
      p += count;
    }
  }
  return plastic_work;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
