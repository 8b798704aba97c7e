// The outline of a section by its parts: ground surface, base, left and right sides, and which edges are held.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "geometry/section.h"

namespace vbgpd {

/// Vertex indices of a counter-clockwise exterior along its parts.
struct Outline {
  std::vector<std::size_t> ground;  ///< leftmost top to rightmost top vertex, left to right
  std::vector<std::size_t>
      base;  ///< lowest vertex at the left end to the lowest at the right end, along the lower side
  std::vector<std::size_t> left, right;  ///< edges at the left and right end, first vertex of each
};
Outline outline_of(const Vertices& exterior);

/// y at x of a line of points from left to right; it goes on level beyond its ends.
Real height_at(const std::vector<Point>& line, Real x);

/// A straight piece of the exterior, counter-clockwise (the soil to its left), that holds the soil.
struct HeldEdge {
  Vec2 a, b;
  Vec2 normal;  ///< unit, outward
  Hold hold = Hold::kFree;
  Index boundary = -1;
};

/// The scene's boundaries, or base fixed and sides on rollers when it has none.
std::vector<BoundaryDef> boundaries_of(const SceneDef& scene);

/// The held edges in the local frame. Between two points of a polyline the shorter way along the exterior is held.
std::vector<HeldEdge> held_edges(const std::vector<BoundaryDef>& boundaries, const Vertices& exterior,
                                 const Vec2& origin);

}  // namespace vbgpd
