// Stress of one particle over one step: gap memory, exact rotation, elastic trial, return to the yield surface.
#pragma once

#include "material/cone.h"
#include "material/hexagon.h"
#include "step/flow_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// What one update did.
struct StressUpdate {
  double return_ratio;  ///< sqrt(J2) / sqrt(J2 trial): 1 elastic, 0 stress free
  double work;          ///< sigma : L dt, Pa, with the mean of the stress before and after
};

VBGPD_INLINE Returned<double> returned(const FlowLaw& law, double extra_cohesion, const Stress<double>& trial) {
  LawConstants constants = law.constants;
  constants.k += extra_cohesion * constants.k_per_cohesion;
  return law.algorithm == 0 ? Cone<double>(constants).returned(trial) : Hexagon<double>(constants).returned(trial);
}

/// stress: deviator xx, yy, xy and mean; l: velocity gradient xx, xy, yx, yy at the end of the drift. The gradient in
/// the middle of it, G = L (1 - L dt/2)^-1, is exactly antisymmetric for a rigid turn (Hughes & Winget 1980). 1 a
/// particle that came apart in tension closes before it carries pressure again (without that memory it would be
///   given volume and energy);
/// 2 the deviator turns exactly by the angle of that turn;
/// 3 elastic increment; 4, 5 tension cut-off and yield surface by the return of the law.
/// Where the law lets particles die, `dead` turns 1 with the first return and leaves pressure only.
template <class PairLaw>
VBGPD_INLINE StressUpdate update_stress(const FlowLaw& law, double extra_cohesion, double dt, const double* l,
                                        double* stress, double& gap, double& plastic_strain, double* dead) {
  const double axx = 1 - 0.5 * dt * l[0], axy = -0.5 * dt * l[1], ayx = -0.5 * dt * l[2], ayy = 1 - 0.5 * dt * l[3];
  const double inverse = 1 / (axx * ayy - axy * ayx);
  const double lxx = (l[0] * ayy - l[1] * ayx) * inverse, lxy = (l[1] * axx - l[0] * axy) * inverse;
  const double lyx = (l[2] * ayy - l[3] * ayx) * inverse, lyy = (l[3] * axx - l[2] * axy) * inverse;
  const double shear = law.constants.shear_modulus, bulk = law.constants.bulk_modulus;
  double opening = (lxx + lyy) * dt;
  if (PairLaw::kGapMemory && gap > 0 && opening < 0) {
    const double closed = smaller(gap, -opening);
    gap -= closed;
    opening += closed;
  }
  const double a = 0.25 * (lyx - lxy) * dt, denominator = 1 / (1 + a * a);  // tan of half the angle
  const double cosine = (1 - a * a) * denominator, sine = 2 * a * denominator;
  const double cos2 = cosine * cosine - sine * sine, sin2 = 2 * cosine * sine;
  const double sxx = stress[0], syy = stress[1], sxy = stress[2], mean = stress[3];
  const double middle = 0.5 * (sxx + syy), half = 0.5 * (sxx - syy);
  const double turned_half = cos2 * half - sin2 * sxy;
  const double rxx = middle + turned_half, ryy = middle - turned_half, rxy = sin2 * half + cos2 * sxy;
  const double third = (lxx + lyy) / 3;
  const Stress<double> trial{rxx + 2 * shear * dt * (lxx - third), ryy + 2 * shear * dt * (lyy - third),
                             rxy + shear * dt * (lxy + lyx), mean + bulk * opening};
  Returned<double> r = returned(law, extra_cohesion, trial);
  const Stress<double>& s = r.stress;
  double ratio = 1;
  if (r.any) {
    const double before = root(trial.j2()), after = root(s.j2());
    ratio = before > 0 ? smaller(after / before, 1) : 0;
    plastic_strain += larger(before - after, 0) / shear;
    if constexpr (PairLaw::kGapMemory) gap += larger(trial.m - s.m, 0) / bulk;
  }
  if constexpr (PairLaw::kDies) {
    if (r.any) *dead = 1;
    if (*dead != 0) r.stress = {0, 0, 0, smaller(trial.m, 0)}, ratio = 0;
  }
  const double mxx = 0.5 * (rxx + s.xx), myy = 0.5 * (ryy + s.yy), mxy = 0.5 * (rxy + s.xy), mm = 0.5 * (mean + s.m);
  stress[0] = s.xx, stress[1] = s.yy, stress[2] = s.xy, stress[3] = s.m;
  return {ratio, dt * ((mxx + mm) * lxx + (myy + mm) * lyy + mxy * (lxy + lyx))};
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
