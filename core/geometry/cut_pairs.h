// Pairs of seeds that see each other only through air.
#pragma once

#include <vector>

#include "geometry/cell_index.h"
#include "geometry/outline.h"

namespace vbgpd {

/// Pairs nearer than `support` spacings, not both walls, whose joining segment leaves the soil and comes back: it
/// properly crosses the exterior outwards and inwards through edges that are not held, stays outside for more than a
/// quarter of the smaller spacing in between, and runs for more than a tenth of it on either side of that piece. So a
/// bond is not cut because the centre of a cut cell lies on or slightly outside the face, nor behind a held edge (wall
/// cells stand there), nor when it grazes a face; a convex section has none. `places` are the particles of the seeds;
/// all in the local frame; sorted.
/// Only seeds within the support of an edge are tested.
std::vector<CutPair> cut_pairs(const Vertices& exterior, const std::vector<HeldEdge>& held,
                               const std::vector<Seed>& seeds, const Vertices& places, const Vec2& spacing,
                               Real support);

}  // namespace vbgpd
