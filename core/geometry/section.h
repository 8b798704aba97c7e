// From checked polygons to particles-to-be: a lattice whose cells are cut by the profile, so that volume and mass are
// exact.
#pragma once

#include <cstdint>
#include <vector>

#include "base/types.h"
#include "scene/scene_def.h"

namespace vbgpd {

/// A uniform lattice of cells. Cell (ix, iy) spans origin + spacing * [ix, ix+1] x [iy, iy+1]; its particle sits in the
/// centre, or near it (Section::shifts).
struct Lattice {
  Vec2 origin =
      Vec2::Zero();  ///< scene coordinates of the lower left corner of cell (0, 0) = lower left of the profile's box, m
  Vec2 spacing = Vec2::Zero();  ///< m; x and y may differ by a few per cent so that key lines fall on cell edges
  Vec2 misfit =
      Vec2::Zero();  ///< largest distance of a key line from a cell edge of the coarsest grid, in its spacings
  Vec2 local_center(Index ix, Index iy) const { return {(ix + 0.5) * spacing.x(), (iy + 0.5) * spacing.y()}; }
  Vec2 center(Index ix, Index iy) const { return origin + local_center(ix, iy); }
};

/// What holds a wall particle.
enum class Hold : std::uint8_t { kFree, kFixed, kRoller, kVelocity };

/// A particle to be.
struct Seed {
  Index ix = 0, iy = 0;  ///< lattice cell; wall seeds may have negative indices
  Real volume = 0;       ///< exact area of soil in the cell (slivers of merged neighbours included), m2 per metre run
  Vec2 centroid = Vec2::Zero();  ///< of that area, scene coordinates (soil only; walls: the cell centre)
  Index material = -1;           ///< index into SceneDef::materials: the material with the largest share of the cell
  Hold hold = Hold::kFree;       ///< kFree = soil; anything else = wall
  bool active = true;            ///< false: its layer is switched off, there is nothing here
  Index boundary = -1;           ///< index into SceneDef::boundaries (or the default ones) for wall seeds
  Index layer = -1;  ///< the layer that holds most of the cell's material; of a wall: of the soil it copies it from
  Vec2 normal = Vec2::Zero();  ///< unit outward normal of the wall; rollers may not move along it
};

/// A pair of seeds within reach whose joining segment leaves the soil: no bond through air.
struct CutPair {
  Index a = 0, b = 0;  ///< indices into Section::seeds, a < b
};

struct Section {
  Lattice lattice;
  std::vector<Seed> seeds;              ///< sorted by (ix, iy), each cell at most once
  std::vector<Vec2> shifts;             ///< of the seeds' particles out of their cells' centres, m; empty = none
  std::vector<CutPair> cut_pairs;       ///< sorted
  Polygon exterior;                     ///< of the soil that is there, counter-clockwise
  std::vector<Point> ground;            ///< upper chain of the exterior from left to right: the ground surface
  std::vector<BoundaryDef> boundaries;  ///< the scene's, or the defaults when it has none
  Real area = 0;                        ///< of the exterior, m2
  Real height = 0;  ///< H: crest minus toe elevation of the ground surface (section height when flat), m
  /// Where the particle of seed k sits, from the lattice's origin.
  Vec2 local_place(std::size_t k) const {
    const Vec2 center = lattice.local_center(seeds[k].ix, seeds[k].iy);
    return shifts.empty() ? center : Vec2(center + shifts[k]);
  }
  Vec2 place(std::size_t k) const { return lattice.origin + local_place(k); }  ///< the same, scene coordinates
};

/// A lattice close to `spacing` whose lines meet the key lines (extent, base, toe, crest, vertical faces, horizontal
/// layer boundaries, load ends) on every `multiple`-th cell edge, so that lattices `multiple` times coarser meet them
/// too. The extent in x and the base always fit exactly; the rest as well as possible with spacings within 10 % of the
/// one asked.
Lattice fit_lattice(const SceneDef& scene, Real spacing, int multiple);

/// Throws Error(kRange | kLimit) unless a lattice of that spacing suits a section of that width and height, m.
void require_spacing(Real spacing, const Vec2& size);

/// The same lattice with cells `factor` times larger.
Lattice coarsened(const Lattice& lattice, int factor);

/// Cuts the lattice by the profile. Sum of soil volumes = exterior area to round-off. Cells with less than half a cell
/// of soil are merged into the adjoining cell that holds the least soil (measured on a 2:1 face at H/10: 0.5 % less
/// error in FS than merging across the longest common edge). Wall cells fill `reach` cells behind each held boundary.
/// Throws Error(kLimit) when more than max_particles would be needed (0 = no limit), Error(kGeometry) when the exterior
/// encloses next to no area.
Section discretise(const SceneDef& scene, const Lattice& lattice, int reach, std::int64_t max_particles);

}  // namespace vbgpd
