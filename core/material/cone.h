// Return to a cone sqrt(J2) + 3 alpha m = k with a cap on the mean stress: the algorithm behind Drucker-Prager,
// undrained and elastic.
#pragma once

#include "material/constants.h"
#include "material/stress.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// The constants of a cone, spread over the lanes.
template <class R>
struct Cone {
  static constexpr int kAlgorithm = static_cast<int>(ReturnAlgorithm::kCone);
  double shear, bulk, a, b, t;
  R k;  ///< differs between lanes where cohesion grows with depth
  VBGPD_INLINE explicit Cone(const LawConstants& c)
      : shear(c.shear_modulus), bulk(c.bulk_modulus), a(c.a), b(c.b), t(c.t), k(filled<R>(c.k)) {}

  /// Whether a trial stress yields.
  struct Look {
    Truth<R> yields;
  };
  VBGPD_INLINE Look look(const Stress<R>& trial, R strength) const {
    const R limit = strength - a * smaller(trial.m, filled<R>(t));
    const Truth<R> sheared = trial.j2() > limit * limit, torn = trial.m > t;
    return {static_cast<Truth<R>>(sheared | torn)};
  }

  /// Closed-form return where a lane yields: mean stress capped at t, then
  ///   dlambda = f / (G + 9 K alpha_phi alpha_psi),  sqrt(J2) -= G dlambda,  m -= 3 K alpha_psi dlambda,
  /// and the apex where sqrt(J2) would turn negative. Exact: a second return changes nothing.
  VBGPD_INLINE Returned<R> returned(const Stress<R>& trial, const Look& looked, R strength) const {
    const R zero = R{};
    const auto yields = looked.yields;
    const R m_cap = smaller(trial.m, filled<R>(t));
    const R limit = strength - a * m_cap;  // strength at the capped mean stress
    const R j2 = trial.j2();
    const R root_j2 = root(j2);
    if (b == 0) {  // isochoric flow: the deviator shrinks onto the cone at the capped mean stress
      const R ratio = smaller(larger(limit, zero) / larger(root_j2, filled<R>(1e-300)), filled<R>(1.0));
      return {{trial.xx * ratio, trial.yy * ratio, trial.xy * ratio, m_cap}, zero, true};
    }
    const R excess = larger(root_j2 - limit, zero);
    const auto capped = trial.m > t;
    const R dilation = select(capped, zero, zero + b);  // at the cap the mean stress is pinned: no dilatancy
    const R lambda = excess / (shear + bulk * a * dilation);
    R root_new = root_j2 - shear * lambda;
    R m_new = m_cap - bulk * dilation * lambda;
    const auto apex = root_new < zero;
    root_new = select(apex, zero, root_new);
    m_new = select(apex, strength / larger(a, 1e-300), m_new);
    const auto sheared = root_j2 > zero;
    const R ratio = select(sheared & yields, root_new / select(sheared, root_j2, filled<R>(1.0)), filled<R>(1.0));
    const R dilated = dilation * select(apex, root_j2 / shear, lambda);
    return {{trial.xx * ratio, trial.yy * ratio, trial.xy * ratio, select(yields, m_new, trial.m)},
            select(yields, dilated, zero),
            true};
  }
};

}  // namespace VBGPD_ISA
}  // namespace vbgpd
