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
  /// Whether the points span a plane; else they lie on a line, or are one.
  bool spans() const {
    const double xx = spread(1, 1), yy = spread(2, 2), xy = spread(1, 2);
    return apart() && xx * yy - xy * xy > kThin * (xx + yy) * (xx + yy);
  }
  /// The plane's value in the middle. Of points on a line that of the straight line through their values at the foot of
  /// the middle on it: nothing is known across.
  void value(double* out, int components) const {
    const double weight = normal_[0][0], x = normal_[0][1] / weight, y = normal_[0][2] / weight;  // their centre
    const double xx = spread(1, 1), yy = spread(2, 2), xy = spread(1, 2), determinant = xx * yy - xy * xy;
    double gx = 0, gy = 0;  // the value in the middle is the mean minus what the centre is off, by these
    if (spans()) {
      gx = (yy * x - xy * y) / determinant, gy = (xx * y - xy * x) / determinant;
    } else if (apart()) {
      const double half = (xx - yy) / 2, root = std::hypot(half, xy), largest = (xx + yy) / 2 + root;
      const double ax = half >= 0 ? half + root : xy, ay = half >= 0 ? xy : root - half;  // along the line
      const double along = (ax * x + ay * y) / (largest * (ax * ax + ay * ay));
      gx = along * ax, gy = along * ay;
    }
    for (int c = 0; c < components; ++c) {
      const auto& r = right_[static_cast<std::size_t>(c)];
      const double mean = r[0] / weight;
      out[c] = mean - gx * (r[1] / weight - mean * x) - gy * (r[2] / weight - mean * y);
    }
  }

 private:
  static constexpr double kThin = 1e-4;  // ratio of the smaller spread to the larger: as good as a line
  static constexpr double kOne = 1e-8;   // spread over the square of the distance to the middle: as good as a point
  bool apart() const {
    const auto& n = normal_;
    return spread(1, 1) + spread(2, 2) > kOne * (n[1][1] + n[2][2]) / n[0][0];
  }
  /// Weighted second moment about the centre.
  double spread(std::size_t a, std::size_t b) const {
    const auto& n = normal_;
    return n[a][b] / n[0][0] - n[0][a] / n[0][0] * (n[0][b] / n[0][0]);
  }

  double normal_[3][3] = {};
  std::array<std::array<double, 3>, kMostComponents> right_{};
};

}  // namespace vbgpd
