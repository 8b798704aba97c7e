// Points sorted into square buckets, to find those near a place.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/scene_def.h"

namespace vbgpd {

class Buckets {
 public:
  /// `size` is the side of a bucket, m; it grows where it would make far more buckets than points.
  Buckets(const std::vector<Point>& points, double size);
  /// Calls f(index) for all points in the buckets that a square of half side `reach` around (x, y) touches.
  template <class F>
  void near(double x, double y, double reach, F&& f) const {
    const long i0 = column(x - reach), i1 = column(x + reach), j0 = row(y - reach), j1 = row(y + reach);
    for (long j = j0; j <= j1; ++j)
      for (long i = i0; i <= i1; ++i) {
        const auto b = static_cast<std::size_t>(j * columns_ + i);
        for (std::size_t k = start_[b]; k < start_[b + 1]; ++k) f(order_[k]);
      }
  }
  /// The one of `points` (those the buckets were made of, at least one) nearest to (x, y), the first of several.
  std::size_t nearest(const std::vector<Point>& points, double x, double y) const;
  double size() const { return size_; }
  /// Half side of a square around any point near the points that holds them all.
  double extent() const { return size_ * static_cast<double>(columns_ + rows_); }

 private:
  long column(double x) const { return index((x - x0_) / size_, columns_); }
  long row(double y) const { return index((y - y0_) / size_, rows_); }
  static long index(double at, long count) {
    return static_cast<long>(std::clamp(std::floor(at), 0.0, static_cast<double>(count - 1)));
  }
  double x0_ = 0, y0_ = 0, size_ = 1;
  long columns_ = 1, rows_ = 1;
  std::vector<std::size_t> start_, order_;
};

}  // namespace vbgpd
