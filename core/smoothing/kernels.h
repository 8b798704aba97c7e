// Kernels W(r, h) of compact support 2h in 2D. The bond weight of VB-GPD is any of them (method: omega_ij = W(r)).
// To add one: a struct here, its name in AnyKernel; scenes may name it then, and it joins the typed tests.
#pragma once

#include <cmath>
#include <string_view>
#include <variant>

#include "base/real.h"

namespace vbgpd {

/// Wendland C2 (Wendland 1995): W = 7/(4 pi h^2) (1 - q/2)^4 (2q + 1), q = r/h < 2.
struct WendlandC2 {
  static constexpr std::string_view name = "wendland_c2";
  static Real value(Real r, Real h) {
    const Real q = r / h;
    if (q >= 2) return 0;
    const Real a = 1 - q / 2, a2 = a * a;
    return 7 / (4 * kPi * h * h) * a2 * a2 * (2 * q + 1);
  }
  static Real derivative(Real r, Real h) {
    const Real q = r / h;
    if (q >= 2) return 0;
    const Real a = 1 - q / 2;
    return -5 * (7 / (4 * kPi * h * h)) / h * q * a * a * a;
  }
};

/// Cubic spline (Monaghan & Lattanzio 1985): sigma = 10/(7 pi h^2), support 2h.
struct CubicSpline {
  static constexpr std::string_view name = "cubic_spline";
  static Real value(Real r, Real h) {
    const Real q = r / h, sigma = 10 / (7 * kPi * h * h);
    if (q >= 2) return 0;
    if (q > 1) return sigma * (2 - q) * (2 - q) * (2 - q) / 4;
    return sigma * (1 - 1.5 * q * q * (1 - q / 2));
  }
  static Real derivative(Real r, Real h) {
    const Real q = r / h, sigma = 10 / (7 * kPi * h * h);
    if (q >= 2) return 0;
    if (q > 1) return -0.75 * sigma / h * (2 - q) * (2 - q);
    return -3 * sigma / h * q * (1 - 0.75 * q);
  }
};

using AnyKernel = std::variant<WendlandC2, CubicSpline>;

}  // namespace vbgpd
