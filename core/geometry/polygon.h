// Plane polygons in the local frame (scene coordinates minus the lower left corner of the box, so that map-sized
// coordinates lose no digits in areas): boxes, areas, moments, inside or outside.
#pragma once

#include <vector>

#include "base/types.h"
#include "scene/scene_def.h"

namespace vbgpd {

using Vertices = std::vector<Vec2>;

struct Box {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  Vec2 size() const { return high - low; }
  Real extent() const { return size().maxCoeff(); }
};

/// Area and first moments: area = integral dA, first = integral x dA.
struct Moments {
  Real area = 0;
  Vec2 first = Vec2::Zero();
};

Box box_of(const Polygon& polygon);
Box box_of(const Vertices& polygon);

/// The polygon without the repeated last vertex.
Polygon open_polygon(const Polygon& polygon);

/// Counter-clockwise, no vertex repeated in a row; still in scene coordinates.
Polygon counter_clockwise(const Polygon& polygon);

/// The same points minus `origin`.
Vertices local(const Polygon& polygon, const Vec2& origin);

/// Positive for counter-clockwise.
Real signed_area(const Vertices& polygon);

/// Signed moments; exact also for the bridged polygons that half-plane clipping makes of concave ones.
Moments moments_of(const Vertices& polygon);

/// Even-odd rule; the rim may go either way.
bool contains(const Vertices& polygon, const Vec2& p);
bool contains(const Polygon& polygon, const Vec2& p);

bool is_convex(const Vertices& counter_clockwise_polygon);

/// The point of the segment ab nearest to p.
Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b);
/// Distance of p from the segment ab.
Real distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b);

inline Real cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Length below which two coordinates of this size and at this spacing cannot be told apart.
Real coordinate_noise(const Box& scene_box);

}  // namespace vbgpd
