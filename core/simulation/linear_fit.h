// Weighted fit of a plane through values around a place (moving least squares, linear): exact for linear fields.
#pragma once

#include <array>
#include <cmath>

namespace vbgpd {

/// Add what is near, then ask for the value at the middle. Distances are in units of the support.
class LinearFit {
 public:
  static constexpr int kMostComponents = 4;
  void add(double weight, double dx, double dy, const double* values, int components) {
    const double row[3] = {1, dx, dy};
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) normal_[a][b] += weight * row[a] * row[b];
      for (int c = 0; c < components; ++c) right_[static_cast<std::size_t>(c)][a] += weight * row[a] * values[c];
    }
  }
  double weight() const { return normal_[0][0]; }
  /// The plane's value in the middle; the weighted mean where the points lie on a line or are too few for a plane.
  void value(double* out, int components) const {
    const auto& n = normal_;
    const double c00 = n[1][1] * n[2][2] - n[1][2] * n[1][2], c01 = n[0][2] * n[1][2] - n[0][1] * n[2][2],
                 c02 = n[0][1] * n[1][2] - n[0][2] * n[1][1];
    const double determinant = n[0][0] * c00 + n[0][1] * c01 + n[0][2] * c02;
    const double scale = n[0][0] * n[1][1] * n[2][2];
    const bool plane = determinant > 1e-6 * scale && scale > 0;
    for (int c = 0; c < components; ++c) {
      const auto& r = right_[static_cast<std::size_t>(c)];
      out[c] = plane ? (c00 * r[0] + c01 * r[1] + c02 * r[2]) / determinant : r[0] / n[0][0];
    }
  }

 private:
  double normal_[3][3] = {};
  std::array<std::array<double, 3>, kMostComponents> right_{};
};

}  // namespace vbgpd
