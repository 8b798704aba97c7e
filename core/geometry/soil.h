// Soil cells: exact volumes and centroids, the material each holds most of, and the merging of slivers.
#pragma once

#include <array>
#include <vector>

#include "geometry/cell_index.h"
#include "geometry/clip.h"

namespace vbgpd {

/// What is kept of a cell that the exterior cuts.
struct CutCell {
  Vertices outline;             ///< the soil in the cell; bridged when it is in several pieces
  std::array<Real, 4> contact;  ///< length of soil along the cell's left, right, bottom and top edge
};

/// Soil seeds in the local frame (centroids too), sorted by (ix, iy).
struct Soil {
  std::vector<Seed> seeds;
  std::vector<Index> cut_of;  ///< per seed: index into `cut`, or -1 for a full cell
  std::vector<CutCell> cut;
};

/// Every cell with any soil. Throws Error(kLimit) once more than max_particles cells are at least half full (0 = no
/// limit).
Soil cut_soil(const Vertices& exterior, const GridLines& grid, const Vec2& spacing, std::int64_t max_particles);

/// The material with the largest share of each cell; layers painted in order, the later one wins a tie.
/// Throws Error(kUnknownName) for a layer whose material does not exist, Error(kGeometry) when no layer has any soil.
void assign_materials(const SceneDef& scene, const Vec2& origin, const GridLines& grid, const Vec2& spacing,
                      Soil& soil);

/// Merges cells with less than half a cell of soil into a neighbour: smallest first, into the 4-neighbour across a
/// common soil edge that holds the least soil (one at least half full before another sliver; at equal volume the longer
/// edge), else into an 8-neighbour; kept when it has none. `slack` is the relative error of a cell's volume, so that
/// exact halves stay.
void merge_slivers(const GridLines& grid, const Vec2& spacing, Real slack, Soil& soil);

}  // namespace vbgpd
