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
    apex_per_k_ = a > 0 ? 0.5 / a : std::numeric_limits<double>::infinity();
  }

  /// Whether a trial stress yields, and what says so: its principal stresses and the yield function of the main plane.
  struct Look {
    Principal<R> s;  ///< sorted principal stresses less the mean stress
    R diameter, f;
    Truth<R> yields;
  };
  VBGPD_INLINE Look look(const Stress<R>& trial, R strength) const {
    const R zz = trial.zz(), half = zz * -0.5, difference = trial.xx - trial.yy;
    const R diameter = root(difference * difference + 4.0 * (trial.xy * trial.xy));
    const R s1 = larger(half + 0.5 * diameter, zz), s3 = smaller(half - 0.5 * diameter, zz);
    const R f = yield(s1, s3) + (2 * a * trial.m - strength);
    const Truth<R> sheared = f > R{}, torn = s1 + trial.m > t;
    return {{s1, -(s1 + s3), s3}, diameter, f, static_cast<Truth<R>>(sheared | torn)};
  }

  /// Closed-form return where a lane yields; all shear regimes in lockstep, the rare cut-off lane by lane. Exact: a
  /// second return changes nothing.
  VBGPD_INLINE Returned<R> returned(const Stress<R>& trial, const Look& looked, R strength) const {
    const R zero = R{};
    const Truth<R> yields = looked.yields;

    Principal<R> p = shear_return(looked, larger(looked.f, zero));
    R mean = (p.s1 + p.s2 + p.s3) * (1.0 / 3.0);
    const R apex = strength * apex_per_k_;  // c cot phi
    const auto beyond = trial.m + mean > apex;
    if (any(beyond)) {
      mean = select(beyond, apex - trial.m, mean);
      p = {select(beyond, mean, p.s1), select(beyond, mean, p.s2), select(beyond, mean, p.s3)};
    }
    if (any(p.s1 + trial.m > t)) {
      cut_off(looked.s, trial.m, strength, p);
      mean = (p.s1 + p.s2 + p.s3) * (1.0 / 3.0);
    }

    // back from sorted to in-plane major, in-plane minor and zz
    const R zz = trial.zz(), difference = trial.xx - trial.yy;
    const R major = select(zz >= looked.s.s1, p.s2, p.s1), minor = select(zz <= looked.s.s3, p.s2, p.s3);
    const R ratio = (major - minor) / larger(looked.diameter, filled<R>(1e-300));
    const R center = (major + minor) * 0.5 - mean, offset = 0.5 * difference;
    Returned<R> out;
    out.stress = {select(yields, center + offset * ratio, trial.xx), select(yields, center - offset * ratio, trial.yy),
                  select(yields, trial.xy * ratio, trial.xy), select(yields, trial.m + mean, trial.m)};
    out.dilated = zero;
    if (b > 0) out.dilated = select(looked.s.s1 + trial.m <= t, larger(-mean, zero) / bulk, zero);
    out.any = true;
    return out;
  }

 private:
  double neutral_, major_, minor_, own_, upper_, lower_, per_own_, per_upper_, per_lower_, apex_per_k_;

  /// What a plane's yield function has of its largest and smallest stress; the deviators' mean and k are the same for
  /// all planes.
  VBGPD_INLINE R yield(R s1, R s3) const { return s1 * (1 + a) - s3 * (1 - a); }

  /// Main plane; where it would put the stresses out of order, two planes at once (upper edge: sigma_1 = sigma_2, lower
  /// edge: sigma_2 = sigma_3). Stresses less the mean stress of the trial.
  VBGPD_INLINE Principal<R> shear_return(const Look& looked, R f) const {
    const Principal<R>& s = looked.s;
    R x = f * per_own_;
    Principal<R> p{s.s1 - x * major_, s.s2 - x * neutral_, s.s3 - x * minor_};
    const R slack = (s.s1 - s.s3) * 1e-14;
    const Truth<R> upper = p.s2 > p.s1 + slack, lower = p.s3 > p.s2 + slack;
    if (any(upper | lower)) {
      // the yield function of the second plane differs by that of the axis it does not share with the first
      const R g = f + select(upper, (s.s2 - s.s1) * (1 + a), (s.s3 - s.s2) * (1 - a));
      const R cross = select(upper, filled<R>(upper_), filled<R>(lower_));
      const R per = select(upper, filled<R>(per_upper_), filled<R>(per_lower_));
      const R y = select(upper | lower, (g * own_ - f * cross) * per, R{});
      x -= y * cross * per_own_;
      p = {s.s1 - x * major_ - y * select(upper, filled<R>(neutral_), filled<R>(major_)),
           s.s2 - x * neutral_ - y * select(upper, filled<R>(major_), filled<R>(minor_)),
           s.s3 - x * minor_ - y * select(upper, filled<R>(minor_), filled<R>(neutral_))};
    }
    return p;
  }

  VBGPD_INLINE void cut_off(const Principal<double>& s, double m, double strength, Principal<double>& p) const {
    if (p.s1 + m > t) p = cut_off(s, m, strength);
  }
  void cut_off(const Principal<Pack>& s, const Pack& m, const Pack& strength, Principal<Pack>& p) const {
    for (int l = 0; l < kWidth; ++l) {
      if (!(p.s1[l] + m[l] > t)) continue;
      const Principal<double> r = cut_off({s.s1[l], s.s2[l], s.s3[l]}, m[l], strength[l]);
      p.s1[l] = r.s1, p.s2[l] = r.s2, p.s3[l] = r.s3;
    }
  }
  Principal<double> cut_off(const Principal<double>& s, double m, double strength) const {
    const Principal<double> r = CutOffReturn(constants())({s.s1 + m, s.s2 + m, s.s3 + m}, strength);
    return {r.s1 - m, r.s2 - m, r.s3 - m};
  }
  LawConstants constants() const {
    LawConstants c;
    c.shear_modulus = shear, c.bulk_modulus = bulk, c.a = a, c.b = b, c.t = t;
    return c;
  }
};

}  // namespace VBGPD_ISA
}  // namespace vbgpd
