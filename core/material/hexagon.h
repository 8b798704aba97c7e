// Return to the Mohr-Coulomb planes with a tension cut-off, in principal stresses: main plane, two edges, apex,
// cut-off (de Souza Neto et al. 2008, ch. 8).
#pragma once

#include "material/constants.h"
#include "material/stress.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Principal stresses, largest (most tensile) first.
template <class R>
struct Principal {
  R s1, s2, s3;
};

/// Cut-off planes sigma_i <= t with associated flow; where the shear plane is violated too, the corner of both. For
/// trials whose shear return leaves sigma_1 above t.
class CutOffReturn {
 public:
  explicit CutOffReturn(const LawConstants& c)
      : g_(c.shear_modulus),
        lame_(c.bulk_modulus - 2.0 / 3.0 * c.shear_modulus),
        sin_phi_(c.a),
        sin_psi_(c.b),
        t_(c.t) {}

  Principal<double> operator()(const Principal<double>& trial, double k) const {
    const double m = lame_ + 2 * g_, over = trial.s1 - t_;
    Principal<double> s{t_, trial.s2 - over * lame_ / m, trial.s3 - over * lame_ / m};
    if (s.s2 > t_) {  // two planes: solve [[m, lame], [lame, m]] x = over_i
      const double x = (over + trial.s2 - t_) / (m + lame_);
      s = {t_, t_, trial.s3 - lame_ * x};
    }
    if (s.s3 > t_) s = {t_, t_, t_};
    if (!((s.s1 - s.s3) + (s.s1 + s.s3) * sin_phi_ - k > 0)) return s;
    // corner: sigma_1 = t and the shear plane; the minor stress follows from yield, the intermediate from both flows
    const double minor = (t_ * (1 + sin_phi_) - k) / (1 - sin_phi_);
    const double volumetric = 2 * sin_psi_ * lame_;
    const Principal<double> shear{volumetric + 2 * g_ * (1 + sin_psi_), volumetric,
                                  volumetric - 2 * g_ * (1 - sin_psi_)};
    const double r1 = over, r3 = trial.s3 - minor, det = shear.s1 * lame_ - m * shear.s3;
    const double x = (r1 * lame_ - m * r3) / det, y = (shear.s1 * r3 - r1 * shear.s3) / det;
    const double middle = trial.s2 - x * shear.s2 - y * lame_;
    return {t_, middle > t_ ? t_ : (middle < minor ? minor : middle), minor};
  }

 private:
  double g_, lame_, sin_phi_, sin_psi_, t_;
};

/// The constants of a Mohr-Coulomb hexagon, spread over the lanes.
template <class R>
struct Hexagon {
  static constexpr int kAlgorithm = static_cast<int>(ReturnAlgorithm::kHexagon);
  double shear, bulk, a, b, t;
  R k;  ///< differs between lanes where cohesion grows with depth
  VBGPD_INLINE explicit Hexagon(const LawConstants& constants)
      : shear(constants.shear_modulus),
        bulk(constants.bulk_modulus),
        a(constants.a),
        b(constants.b),
        t(constants.t),
        k(filled<R>(constants.k)) {
    // stress taken off per unit multiplier of a plane: major, neutral and minor direction of that plane
    neutral_ = 2 * b * (bulk - 2.0 / 3.0 * shear);
    major_ = neutral_ + 2 * shear * (1 + b), minor_ = neutral_ - 2 * shear * (1 - b);
    const double own = major_ * (1 + a) - minor_ * (1 - a);
    // what a second plane takes off the first one's yield function: they share the minor (upper edge) or major axis
    upper_ = neutral_ * (1 + a) - minor_ * (1 - a), lower_ = major_ * (1 + a) - neutral_ * (1 - a);
    per_own_ = 1 / own;
    per_upper_ = 1 / (own * own - upper_ * upper_), per_lower_ = 1 / (own * own - lower_ * lower_);
    own_ = own;
  }

  /// Closed-form return; all shear regimes in lockstep, the rare cut-off lane by lane. Exact: a second return changes
  /// nothing.
  VBGPD_INLINE Returned<R> returned(const Stress<R>& s) const {
    const R zero = R{};
    const R half = (s.xx + s.yy) * 0.5, difference = (s.xx - s.yy) * 0.5;
    const R radius = root(difference * difference + s.xy * s.xy), center = s.m + half, zz = s.m - 2.0 * half;
    const R in_major = center + radius, in_minor = center - radius;
    const Principal<R> trial{larger(in_major, zz), larger(in_minor, smaller(in_major, zz)), smaller(in_minor, zz)};
    const R f = yield(trial.s1, trial.s3);
    const auto yields = (f > zero) | (trial.s1 > t);
    if (!any(yields)) return {s, zero, false};

    Principal<R> p = shear_return(trial, larger(f, zero));
    if (any(p.s1 > t)) cut_off(trial, p);

    // back from sorted to in-plane major, in-plane minor and zz
    const auto above = zz > in_major, below = zz < in_minor;
    const R major = select(above, p.s2, p.s1), minor = select(below, p.s2, p.s3);
    const R m = (p.s1 + p.s2 + p.s3) * (1.0 / 3.0);
    const R ratio = (major - minor) * 0.5 / select(radius > zero, radius, filled<R>(1.0)),
            deviator = (major + minor) * 0.5 - m;
    Returned<R> out;
    out.stress = {select(yields, deviator + difference * ratio, s.xx),
                  select(yields, deviator - difference * ratio, s.yy), select(yields, s.xy * ratio, s.xy),
                  select(yields, m, s.m)};
    out.dilated = zero;
    if (b > 0) out.dilated = select(trial.s1 <= t, larger(s.m - out.stress.m, zero) / bulk, zero);
    out.any = true;
    return out;
  }

 private:
  double neutral_, major_, minor_, own_, upper_, lower_, per_own_, per_upper_, per_lower_;

  VBGPD_INLINE R yield(R s1, R s3) const { return (s1 - s3) + (s1 + s3) * a - k; }

  /// Main plane; where it would put the stresses out of order, two planes at once (upper edge: sigma_1 = sigma_2, lower
  /// edge: sigma_2 = sigma_3); beyond the apex, the apex.
  VBGPD_INLINE Principal<R> shear_return(const Principal<R>& trial, R f) const {
    const R step = f * per_own_;
    Principal<R> p{trial.s1 - step * major_, trial.s2 - step * neutral_, trial.s3 - step * minor_};
    const R slack = (magnitude(trial.s1) + magnitude(trial.s3)) * 1e-14;
    const auto upper = p.s2 > p.s1 + slack, lower = p.s3 > p.s2 + slack;
    if (any(upper)) {
      const R g = yield(trial.s2, trial.s3);
      const R x = (f * own_ - g * upper_) * per_upper_, y = (g * own_ - f * upper_) * per_upper_;
      p = {select(upper, trial.s1 - x * major_ - y * neutral_, p.s1),
           select(upper, trial.s2 - x * neutral_ - y * major_, p.s2), select(upper, trial.s3 - (x + y) * minor_, p.s3)};
    }
    if (any(lower)) {
      const R g = yield(trial.s1, trial.s2);
      const R x = (f * own_ - g * lower_) * per_lower_, y = (g * own_ - f * lower_) * per_lower_;
      p = {select(lower, trial.s1 - (x + y) * major_, p.s1), select(lower, trial.s2 - x * neutral_ - y * minor_, p.s2),
           select(lower, trial.s3 - x * minor_ - y * neutral_, p.s3)};
    }
    if (a > 0) {
      const R apex = k * (0.5 / a);  // c cot phi
      const auto beyond = p.s1 + p.s2 + p.s3 > 3.0 * apex;
      if (any(beyond)) p = {select(beyond, apex, p.s1), select(beyond, apex, p.s2), select(beyond, apex, p.s3)};
    }
    return p;
  }

  VBGPD_INLINE void cut_off(const Principal<double>& trial, Principal<double>& p) const {
    if (p.s1 > t) p = CutOffReturn(constants())(trial, k);
  }
  void cut_off(const Principal<Pack>& trial, Principal<Pack>& p) const {
    for (int l = 0; l < kWidth; ++l) {
      if (!(p.s1[l] > t)) continue;
      const Principal<double> r = CutOffReturn(constants())({trial.s1[l], trial.s2[l], trial.s3[l]}, k[l]);
      p.s1[l] = r.s1, p.s2[l] = r.s2, p.s3[l] = r.s3;
    }
  }
  LawConstants constants() const {
    LawConstants c;
    c.shear_modulus = shear, c.bulk_modulus = bulk, c.a = a, c.b = b, c.t = t;
    return c;
  }
};

}  // namespace VBGPD_ISA
}  // namespace vbgpd
