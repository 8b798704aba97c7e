// Wall cells behind the held parts of the outline.
#pragma once

#include <vector>

#include "geometry/cell_index.h"
#include "geometry/outline.h"

namespace vbgpd {

/// Wall seeds in the local frame, sorted by (ix, iy): cells without a soil seed and outside the exterior whose centre
/// is behind a held edge (foot of the perpendicular on the edge) by less than `reach` cells in x and in y, and the
/// corner cells where two held edges meet. The nearest edge holds the cell; at equal distance fixed wins over velocity
/// over roller. Along a vertical edge the rows are those of the soil cells beside it, so that no wall stands higher
/// than the ground. Rollers copy volume and material from the soil along their normal; others are full cells of the
/// nearest soil's material.
std::vector<Seed> wall_seeds(const std::vector<HeldEdge>& edges, const Vertices& exterior,
                             const std::vector<Seed>& soil, const Vec2& spacing, int reach);

}  // namespace vbgpd
