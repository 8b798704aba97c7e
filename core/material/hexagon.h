// Return to the Mohr-Coulomb planes with a tension cut-off, in principal stresses: main plane, two edges, apex,
// cut-off.
#pragma once

#include <array>

#include "material/constants.h"
#include "material/stress.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Principal stresses, largest (most tensile) first.
using Principal = std::array<double, 3>;

/// The general return of one sorted principal trial stress; every regime (method 4.4; de Souza Neto et al. 2008, ch.
/// 8).
class HexagonReturn {
 public:
  explicit HexagonReturn(const LawConstants& c)
      : g_(c.shear_modulus), bulk_(c.bulk_modulus), sin_phi_(c.a), k_(c.k), sin_psi_(c.b), t_(c.t) {}

  Principal operator()(const Principal& trial) const {
    Principal s = shear_return(trial);
    if (s[0] > t_) s = tension_return(trial);
    return s;
  }

 private:
  double yield(const Principal& s, int i, int j) const { return (s[i] - s[j]) + (s[i] + s[j]) * sin_phi_ - k_; }
  /// Stress removed per unit multiplier of the plane of the i-th (major) and j-th (minor) principal stress.
  Principal flow(int i, int j) const {
    Principal d{};
    const double spread = bulk_ - 2.0 / 3.0 * g_;
    const double volumetric = 2 * sin_psi_;  // (1 + sin psi) - (1 - sin psi)
    for (double& v : d) v = spread * volumetric;
    d[i] += 2 * g_ * (1 + sin_psi_);
    d[j] -= 2 * g_ * (1 - sin_psi_);
    return d;
  }
  static double directional(const Principal& d, int i, int j, double sin_phi) {
    return (d[i] - d[j]) + (d[i] + d[j]) * sin_phi;
  }
  static bool sorted(const Principal& s, double slack) { return s[0] >= s[1] - slack && s[1] >= s[2] - slack; }

  Principal shear_return(const Principal& trial) const {
    const double f = yield(trial, 0, 2);
    if (!(f > 0)) return trial;
    const double slack = 1e-14 * (magnitude(trial[0]) + magnitude(trial[2]));
    const Principal main = flow(0, 2);
    const double step = f / directional(main, 0, 2, sin_phi_);
    Principal s;
    for (int i = 0; i < 3; ++i) s[i] = trial[i] - step * main[i];
    if (!sorted(s, slack)) s = edge_return(trial, main, s[1] > s[0]);
    if (sin_phi_ > 0 && s[0] + s[1] + s[2] > 3 * apex()) s = {apex(), apex(), apex()};
    return s;
  }

  /// Two planes at once: with the intermediate stress equal to the major (upper) or to the minor one.
  Principal edge_return(const Principal& trial, const Principal& main, bool upper) const {
    const int i = upper ? 1 : 0, j = upper ? 2 : 1;
    const Principal other = flow(i, j);
    const double a11 = directional(main, 0, 2, sin_phi_), a12 = directional(other, 0, 2, sin_phi_);
    const double a21 = directional(main, i, j, sin_phi_), a22 = directional(other, i, j, sin_phi_);
    const double f1 = yield(trial, 0, 2), f2 = yield(trial, i, j), det = a11 * a22 - a12 * a21;
    const double x = (f1 * a22 - f2 * a12) / det, y = (f2 * a11 - f1 * a21) / det;
    Principal s;
    for (int n = 0; n < 3; ++n) s[n] = trial[n] - x * main[n] - y * other[n];
    return s;
  }
  double apex() const { return k_ / (2 * sin_phi_); }  // c cot phi

  /// Cut-off planes sigma_i <= t with associated flow; where the shear plane is violated too, the corner of both.
  Principal tension_return(const Principal& trial) const {
    Principal s = trial;
    const double lame = bulk_ - 2.0 / 3.0 * g_, m = lame + 2 * g_;
    const double over = trial[0] - t_;
    s = {t_, trial[1] - over * lame / m, trial[2] - over * lame / m};
    if (s[1] > t_) {  // two planes: solve [[m, lame], [lame, m]] x = over_i
      const double o1 = trial[0] - t_, o2 = trial[1] - t_, x = (o1 + o2) / (m + lame);
      s = {t_, t_, trial[2] - lame * x};
    }
    if (s[2] > t_) s = {t_, t_, t_};
    if (!(yield(s, 0, 2) > 0)) return s;
    // corner: sigma_1 = t and the shear plane; the minor stress follows from yield, the intermediate one from both
    // flows
    const double minor = (t_ * (1 + sin_phi_) - k_) / (1 - sin_phi_);
    const Principal shear = flow(0, 2), pull = {m, lame, lame};
    const double r1 = trial[0] - t_, r3 = trial[2] - minor, det = shear[0] * pull[2] - pull[0] * shear[2];
    const double x = (r1 * pull[2] - pull[0] * r3) / det, y = (shear[0] * r3 - r1 * shear[2]) / det;
    const double middle = trial[1] - x * shear[1] - y * pull[1];
    return {t_, middle > t_ ? t_ : (middle < minor ? minor : middle), minor};
  }

  double g_, bulk_, sin_phi_, k_, sin_psi_, t_;
};

/// The constants of a Mohr-Coulomb hexagon, spread over the lanes.
template <class R>
struct Hexagon {
  static constexpr int kAlgorithm = 1;
  LawConstants c;
  double shear, bulk, a, b, t, lambda_scale;
  R k;
  VBGPD_INLINE explicit Hexagon(const LawConstants& constants)
      : c(constants),
        shear(c.shear_modulus),
        bulk(c.bulk_modulus),
        a(c.a),
        b(c.b),
        t(c.t),
        lambda_scale(1 / (4 * c.shear_modulus * (1 + c.a * c.b / 3) + 4 * c.bulk_modulus * c.a * c.b)),
        k(R{} + c.k) {}

  /// Closed-form return. The main plane with sigma_zz in the middle is done in lockstep; the rare other regimes lane by
  /// lane.
  VBGPD_INLINE Returned<R> returned(const Stress<R>& s) const {
    const R zero = R{};
    const R half = (s.xx + s.yy) * 0.5, difference = (s.xx - s.yy) * 0.5;
    const R radius2 = difference * difference + s.xy * s.xy, center = s.m + half, zz = s.m - 2.0 * half;
    const R radius = root(radius2);
    const R major = center + radius, minor = center - radius;
    const R largest = larger(major, zz), smallest = smaller(minor, zz);
    const R f_sorted = (largest - smallest) + (largest + smallest) * a - k;
    const auto yields = (f_sorted > zero) | (largest > t);
    if (!any(yields)) return {s, zero, false};
    // main plane: sigma_1 = major, sigma_3 = minor, method 4.4
    const R f = 2.0 * radius + 2.0 * center * a - k;
    const R step = f * lambda_scale;
    const R major_new = major - (2.0 * shear * (1.0 + b / 3.0) + 2.0 * bulk * b) * step;
    const R zz_new = zz + (4.0 / 3.0 * shear - 2.0 * bulk) * b * step;
    const R minor_new = minor + (2.0 * shear * (1.0 - b / 3.0) - 2.0 * bulk * b) * step;
    const auto main = (major >= zz) & (zz >= minor) & (major_new >= zz_new) & (zz_new >= minor_new) & (major_new <= t);
    const R safe_radius = select(radius > zero, radius, R{} + 1.0);
    const R ratio = select(yields, (major_new - minor_new) * 0.5 / safe_radius, R{} + 1.0);
    const R center_new = select(yields, (major_new + minor_new) * 0.5, center);
    const R m_new = select(yields, (major_new + minor_new + zz_new) / 3.0, s.m);
    const R half_new = center_new - m_new;
    Returned<R> out{{half_new + difference * ratio, half_new - difference * ratio, s.xy * ratio, m_new}, zero, true};
    const auto rest = yields & !main;
    if (any(rest)) other_regimes(s, rest, out.stress);
    if (b > 0) out.dilated = select(largest <= t, larger(s.m - out.stress.m, zero) / bulk, zero);
    return out;
  }

 private:
  VBGPD_INLINE void other_regimes(const Stress<double>& s, bool rest, Stress<double>& out) const {
    if (rest) out = one_lane(s);
  }
  void other_regimes(const Stress<Pack>& s, Mask rest, Stress<Pack>& out) const {
    for (int l = 0; l < kWidth; ++l) {
      if (rest[l] == 0) continue;
      const Stress<double> r = one_lane({s.xx[l], s.yy[l], s.xy[l], s.m[l]});
      out.xx[l] = r.xx, out.yy[l] = r.yy, out.xy[l] = r.xy, out.m[l] = r.m;
    }
  }
  /// Any regime: sort, return, undo the sorting and the rotation.
  Stress<double> one_lane(const Stress<double>& s) const {
    const double half = (s.xx + s.yy) * 0.5, difference = (s.xx - s.yy) * 0.5;
    const double radius = root(difference * difference + s.xy * s.xy), center = s.m + half;
    const double in[3] = {center + radius, center - radius, s.m - 2 * half};  // in-plane major, minor, zz
    int order[3] = {0, 1, 2};
    if (in[order[0]] < in[2]) order[0] = 2, order[1] = 0, order[2] = 1;
    else if (in[1] < in[2]) order[1] = 2, order[2] = 1;
    const Principal p = HexagonReturn(c)({in[order[0]], in[order[1]], in[order[2]]});
    double back[3];
    for (int i = 0; i < 3; ++i) back[order[i]] = p[i];
    const double m = (back[0] + back[1] + back[2]) / 3;
    const double ratio = radius > 0 ? (back[0] - back[1]) / 2 / radius : 0;
    const double h = (back[0] + back[1]) / 2 - m;
    return {h + difference * ratio, h - difference * ratio, s.xy * ratio, m};
  }
};

}  // namespace VBGPD_ISA
}  // namespace vbgpd
