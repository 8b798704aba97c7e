// Values known at scattered places (nodes of another program's mesh) or on a raster, wanted at particles.
#pragma once

#include <span>
#include <vector>

#include "simulation/buckets.h"

namespace vbgpd {

/// Goes through the nodes and reproduces linear fields exactly, also a little beyond the outermost nodes: a plane
/// through the eight nearest nodes, weighted by 1/d^2, or through as many more as it takes to span one (up to 512:
/// beyond that, as along a single borehole, a straight line; across it nothing is known).
class Scattered {
 public:
  /// `values` holds `components` numbers per node; there is at least one node.
  Scattered(std::vector<Point> nodes, std::vector<double> values, int components);
  void at(double x, double y, double* out) const;

 private:
  std::vector<Point> nodes_;
  std::vector<double> values_;
  int components_;
  Buckets buckets_;
};

/// A raster of values at x0 + i dx, y0 + j dy; bilinear, continued linearly beyond its rim.
struct Raster {
  double x0 = 0, y0 = 0, dx = 1, dy = 1;
  std::int64_t nx = 0, ny = 0;
  std::vector<double> values;  ///< [ny x nx], NaN = not known
  /// NaN where one of the four values around is not known.
  double at(double x, double y) const;
};

}  // namespace vbgpd
