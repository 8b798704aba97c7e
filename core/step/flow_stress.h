// Stress of four particles over one step: gap memory, exact rotation, elastic trial, return to the yield surface.
#pragma once

#include "material/cone.h"
#include "material/hexagon.h"
#include "step/flow_data.h"
#include "step/flow_quads.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Soils of four particles.
struct FlowSoils {
  const FlowLaw* law[4];
  Pack shear, bulk, extra_cohesion, loose;
  double disturbed;  ///< plastic shear strain beyond which soil may come loose
  bool same;         ///< all of one soil: returned in lockstep
};

/// What one update did.
struct StressUpdate {
  Pack return_ratio;  ///< sqrt(J2) / sqrt(J2 trial): 1 elastic, 0 stress free
  Pack opening;       ///< tr L dt
  Pack work;          ///< sigma : L dt, Pa, with the mean of the stress before and after
};

template <class Surface, class R>
VBGPD_INLINE Stress<R> returned_to(const FlowLaw& law, R extra_cohesion, const Stress<R>& trial) {
  Surface surface(law.constants);
  surface.k += extra_cohesion * law.constants.k_per_cohesion;
  return return_to(surface, trial).stress;
}

template <class R>
VBGPD_INLINE Stress<R> returned_by(const FlowLaw& law, R extra_cohesion, const Stress<R>& trial) {
  static_assert(kReturnAlgorithms == 2, "what is no cone is a hexagon");
  return law.algorithm == 0 ? returned_to<Cone<R>>(law, extra_cohesion, trial)
                            : returned_to<Hexagon<R>>(law, extra_cohesion, trial);
}

VBGPD_INLINE Stress<Pack> returned(const FlowSoils& soils, const Stress<Pack>& trial) {
  if (soils.same) return returned_by(*soils.law[0], soils.extra_cohesion, trial);
  Stress<Pack> s = trial;
  for (int k = 0; k < 4; ++k) {
    const Stress<double> one = returned_by(*soils.law[k], soils.extra_cohesion[k],
                                           Stress<double>{trial.xx[k], trial.yy[k], trial.xy[k], trial.m[k]});
    s.xx[k] = one.xx, s.yy[k] = one.yy, s.xy[k] = one.xy, s.m[k] = one.m;
  }
  return s;
}

/// stress: deviator xx, yy, xy and mean; l: velocity gradient xx, xy, yx, yy at the end of the drift. The gradient in
/// the middle of it, G = L (1 - L dt/2)^-1, is exactly antisymmetric for a rigid turn (Hughes & Winget 1980).
///
///   1. A particle that came apart in tension closes before it carries pressure again (without that memory it would be
///      given volume and energy).
///
///   2. The deviator turns exactly by the angle of that turn.
///
///   3. Elastic increment.
///
///   4. Tension cut-off, and 5. yield surface, by the return of the law.
///
/// Where the law lets particles die, `dead` turns 1 with the first return and leaves pressure only. around: sum V
/// omega. A loose grain, disturbed soil without two neighbours a spacing away, has contacts and neither stress nor
/// bonds (measured: with the stress of a continuum grains bounce off the toe). What diffuses into it is gone a step
/// later.
template <class PairLaw>
VBGPD_INLINE StressUpdate update_stress(const FlowSoils& soils, double dt, const Quads& l, Pack around, Quads& stress,
                                        Pack& gap, Pack& plastic_strain, Pack& dead) {
  const Pack zero{};
  const Pack axx = 1.0 - 0.5 * dt * l.a, axy = -0.5 * dt * l.b, ayx = -0.5 * dt * l.c, ayy = 1.0 - 0.5 * dt * l.d;
  const Pack inverse = 1.0 / (axx * ayy - axy * ayx);
  const Pack lxx = (l.a * ayy - l.b * ayx) * inverse, lxy = (l.b * axx - l.a * axy) * inverse;
  const Pack lyx = (l.c * ayy - l.d * ayx) * inverse, lyy = (l.d * axx - l.c * axy) * inverse;
  const Pack shear = soils.shear, bulk = soils.bulk;
  const Pack gap_before = gap, expansion = (lxx + lyy) * dt;
  Pack opening = expansion;
  if constexpr (PairLaw::kGapMemory) {
    const Pack closed = larger(smaller(gap, -opening), zero);
    gap -= closed;
    opening += closed;
  }
  const Pack a = 0.25 * (lyx - lxy) * dt, denominator = 1.0 / (1.0 + a * a);  // tan of half the angle
  const Pack cosine = (1.0 - a * a) * denominator, sine = 2.0 * a * denominator;
  const Pack cos2 = cosine * cosine - sine * sine, sin2 = 2.0 * cosine * sine;
  const Pack middle = 0.5 * (stress.a + stress.b), half = 0.5 * (stress.a - stress.b);
  const Pack turned_half = cos2 * half - sin2 * stress.c;
  const Pack rxx = middle + turned_half, ryy = middle - turned_half, rxy = sin2 * half + cos2 * stress.c;
  const Pack third = (lxx + lyy) / 3.0;
  const Stress<Pack> trial{rxx + 2.0 * shear * dt * (lxx - third), ryy + 2.0 * shear * dt * (lyy - third),
                           rxy + shear * dt * (lxy + lyx), stress.d + bulk * opening};
  Stress<Pack> s = returned(soils, trial);
  const auto yields = (s.xx != trial.xx) | (s.yy != trial.yy) | (s.xy != trial.xy) | (s.m != trial.m);
  Pack ratio = zero + 1.0;
  if (any(yields)) {
    const Pack before = root(trial.j2()), after = root(s.j2());
    const auto sheared = before > zero;
    const Pack fraction = select(sheared, smaller(after / select(sheared, before, ratio), ratio), zero);
    ratio = select(yields, fraction, ratio);
    plastic_strain += select(yields, larger(before - after, zero) / shear, zero);
    if constexpr (PairLaw::kGapMemory) gap += select(yields, larger(trial.m - s.m, zero) / bulk, zero);
  }
  if constexpr (PairLaw::kDies) {
    dead = select(yields, zero + 1.0, dead);
    const auto gone = dead != zero;
    s = {select(gone, zero, s.xx), select(gone, zero, s.yy), select(gone, zero, s.xy),
         select(gone, smaller(trial.m, zero), s.m)};
    ratio = select(gone, zero, ratio);
  }
  if constexpr (PairLaw::kGrains) {
    const auto loose = (around < soils.loose) & (plastic_strain > broadcast(soils.disturbed));
    if (any(loose)) {
      s = {select(loose, zero, s.xx), select(loose, zero, s.yy), select(loose, zero, s.xy), select(loose, zero, s.m)};
      ratio = select(loose, zero, ratio);
      gap = select(loose, larger(gap_before + expansion + stress.d / bulk, zero), gap);
    }
  }
  const Pack mxx = 0.5 * (rxx + s.xx), myy = 0.5 * (ryy + s.yy), mxy = 0.5 * (rxy + s.xy), mm = 0.5 * (stress.d + s.m);
  stress = {s.xx, s.yy, s.xy, s.m};
  return {ratio, expansion, dt * ((mxx + mm) * lxx + (myy + mm) * lyy + mxy * (lxy + lyx))};
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
