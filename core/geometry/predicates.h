// The questions to which only an exact answer will do: which side of a line, simple or not. Two builds answer them, one
// by CGAL and one by the engine's own expansions of doubles; both are exact on the coordinates as given.
#pragma once

#include "geometry/polygon.h"

namespace vbgpd {

/// +1 when a, b, c turn left, -1 right, 0 on one line: the exact sign. Coordinates between 1e-100 and 1 in size or 0.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Whether a closed polygon (at least three vertices, none twice in a row) meets itself nowhere.
bool is_simple(const Vertices& polygon);

/// Which build this is.
bool checks_with_cgal() noexcept;

struct Segment {
  Vec2 from, to;
};

/// What two segments have in common: nothing, a point (from == to) or a piece. End points come out exactly; the
/// crossing of two interiors is rounded.
struct Meeting {
  bool any = false;
  bool piece = false;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};
Meeting meeting(const Segment& e, const Segment& f);

/// Whether p lies on the segment, ends included.
bool on_segment(const Vec2& p, const Segment& s);

}  // namespace vbgpd
