// Who is seen where when polygons are painted over each other: exact areas by a sweep over trapezoids.
#pragma once

#include "geometry/polygon.h"

namespace vbgpd {

struct Painted {
  std::vector<Real> inside;        ///< per layer: its area within the exterior
  std::vector<Real> visible;       ///< per layer: what later layers leave of it within the exterior
  Real bare = 0;                   ///< area of the exterior that no layer covers
  Vec2 bare_place = Vec2::Zero();  ///< a point within the largest bare trapezoid
};

/// Paints the layers in order onto the exterior (even-odd inside rule, any winding). A null layer fills the exterior.
/// cost  slabs between all vertices and crossings, each with the edges that span it
Painted paint(const Vertices& exterior, const std::vector<const Vertices*>& layers);

}  // namespace vbgpd
