// Where a section ends upright: the ground is likely to go on there.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/types.h"

namespace vbgpd {

/// x of the left and right end of an outline, m, of those that are upright pieces higher than `least`.
inline std::vector<Real> upright_ends(const Polygon& exterior, Real least) {
  const auto [left, right] =
      std::minmax_element(exterior.begin(), exterior.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  std::vector<Real> ends;
  for (const Real side : {left->x, right->x}) {
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    for (const Point& p : exterior)
      if (std::fabs(p.x - side) <= 1e-9 * (right->x - left->x)) low = std::min(low, p.y), high = std::max(high, p.y);
    if (high - low > least) ends.push_back(side);
  }
  return ends;
}

}  // namespace vbgpd
