// Where a section ends upright: the ground is likely to go on there.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/types.h"

namespace vbgpd {

struct SectionEnd {
  Real x;  ///< m
  const char* name;
};
/// The left and the right end of an outline, if they are upright pieces higher than `least`, m.
inline std::vector<SectionEnd> upright_ends(const Polygon& exterior, Real least) {
  const auto [left, right] =
      std::minmax_element(exterior.begin(), exterior.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  std::vector<SectionEnd> ends;
  for (const SectionEnd& end : {SectionEnd{left->x, "left"}, SectionEnd{right->x, "right"}}) {
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    for (const Point& p : exterior)
      if (std::fabs(p.x - end.x) <= 1e-9 * (right->x - left->x)) low = std::min(low, p.y), high = std::max(high, p.y);
    if (high - low > least) ends.push_back(end);
  }
  return ends;
}

}  // namespace vbgpd
