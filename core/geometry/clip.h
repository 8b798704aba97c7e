// A polygon cut by a grid of lines, cell by cell, with exact areas. Columns first, then rows, halving each time, so
// that the cost follows the cut cells and not the full ones.
#pragma once

#include <functional>

#include "geometry/polygon.h"
#include "geometry/section.h"

namespace vbgpd {

/// The lines of a lattice in the local frame. Lines that miss a polygon vertex by round-off are moved onto it, so that
/// a crest on a cell edge leaves no film of cells 1e-10 high in map coordinates.
struct GridLines {
  Index ix0 = 0, iy0 = 0;  ///< indices of the first column and row
  std::vector<Real> x, y;  ///< column i spans x[i] .. x[i+1]
  Index columns() const { return static_cast<Index>(x.size()) - 1; }
  Index rows() const { return static_cast<Index>(y.size()) - 1; }
};

/// The part of the grid that covers the exterior. `others` are polygons whose vertices the lines should meet as well.
/// Throws Error(kLimit) when more than 2^30 cells would be needed.
GridLines make_grid(const Lattice& lattice, const Vertices& exterior, const std::vector<Vertices>& others, Real noise);

/// Sutherland-Hodgman by one axis-parallel line (axis 0: x, 1: y); keeps the side below or above `at`. A concave
/// polygon may come out bridged along the line; its signed area and moments are still exact.
void clip(const Vertices& polygon, int axis, Real at, bool keep_below, Vertices& out);

struct CellVisitor {
  std::function<void(Index column, Index row_begin, Index row_end)> full;        ///< wholly inside
  std::function<void(Index column, Index row, const Vertices& outline)> partly;  ///< the polygon within this cell
};

/// Visits the cells of the grid that a counter-clockwise polygon touches, in order of column, then row (0-based in the
/// grid).
void cut_by_grid(const Vertices& polygon, const GridLines& grid, const CellVisitor& visit);

}  // namespace vbgpd
