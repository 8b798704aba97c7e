#include <algorithm>

#include "geometry/predicates.h"

namespace vbgpd {

namespace {

bool before(const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); }

/// Both on one line: the overlap in lexicographic order.
Meeting overlap(const Segment& e, const Segment& f) {
  const Vec2 low = std::max(std::min(e.from, e.to, before), std::min(f.from, f.to, before), before);
  const Vec2 high = std::min(std::max(e.from, e.to, before), std::max(f.from, f.to, before), before);
  if (before(high, low)) return {};
  return {true, before(low, high), low, high};
}

}  // namespace

bool on_segment(const Vec2& p, const Segment& s) {
  const auto [low, high] = std::minmax(s.from, s.to, before);
  return orientation(s.from, s.to, p) == 0 && !before(p, low) && !before(high, p);
}

Meeting meeting(const Segment& e, const Segment& f) {
  const int e_from = orientation(f.from, f.to, e.from), e_to = orientation(f.from, f.to, e.to);
  const int f_from = orientation(e.from, e.to, f.from), f_to = orientation(e.from, e.to, f.to);
  if (e_from == 0 && e_to == 0) return overlap(e, f);
  if (e_from * e_to > 0 || f_from * f_to > 0) return {};
  Vec2 at;
  if (e_from == 0) at = e.from;
  else if (e_to == 0) at = e.to;
  else if (f_from == 0) at = f.from;
  else if (f_to == 0) at = f.to;
  else {
    const Vec2 d = f.to - f.from;
    const Real a = cross(d, e.from - f.from), b = cross(d, e.to - f.from);
    const Real t = a != b ? std::clamp(a / (a - b), Real(0), Real(1)) : Real(0.5);
    at = e.from + t * (e.to - e.from);
  }
  return {true, false, at, at};
}

}  // namespace vbgpd
