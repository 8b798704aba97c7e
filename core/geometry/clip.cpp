// Clipping by half planes: Sutherland and Hodgman, Reentrant polygon clipping, CACM 17 (1974) 32-42.
#include "geometry/clip.h"

#include <cmath>

#include "geometry/format.h"

namespace vbgpd {
namespace {

std::vector<Real> lines(Index first, Index last, Real spacing) {
  std::vector<Real> at;
  at.reserve(static_cast<std::size_t>(last - first) + 1);
  for (Index i = first; i <= last; ++i) at.push_back(i * spacing);
  return at;
}

// Moves the line nearest to each vertex onto it when they differ by round-off only; the first vertex wins.
void snap(std::vector<Real>& at, Index first, Real spacing, int axis, const Vertices& polygon, Real tolerance,
          std::vector<bool>& done) {
  for (const Vec2& p : polygon) {
    const Real nearest = std::round(p[axis] / spacing) - first;
    if (!(nearest >= 0 && nearest < static_cast<Real>(at.size()))) continue;
    const auto i = static_cast<std::size_t>(nearest);
    if (done[i] || std::abs(p[axis] - at[i]) > tolerance) continue;
    at[i] = p[axis];
    done[i] = true;
  }
}

class Cutter {
 public:
  Cutter(const GridLines& grid, const CellVisitor& visit) : grid_(grid), visit_(visit) {}

  void columns(const Vertices& piece, Index begin, Index end) {
    if (piece.size() < 3) return;
    if (end - begin == 1) return rows(piece, begin, 0, grid_.rows());
    const Index middle = begin + (end - begin) / 2;
    Vertices half;
    clip(piece, 0, grid_.x[middle], true, half);
    columns(half, begin, middle);
    clip(piece, 0, grid_.x[middle], false, half);
    columns(half, middle, end);
  }

 private:
  void rows(const Vertices& piece, Index column, Index begin, Index end) {
    if (piece.size() < 3) return;
    if (follows_block(piece, column, begin, end)) {
      const Real block = (grid_.x[column + 1] - grid_.x[column]) * (grid_.y[end] - grid_.y[begin]);
      if (signed_area(piece) > block / 2) visit_.full(column, begin, end);
      return;
    }
    if (end - begin == 1) return visit_.partly(column, begin, piece);
    const Index middle = begin + (end - begin) / 2;
    Vertices half;
    clip(piece, 1, grid_.y[middle], true, half);
    rows(half, column, begin, middle);
    clip(piece, 1, grid_.y[middle], false, half);
    rows(half, column, middle, end);
  }

  // True when every edge runs along the outline of the block, so that the block is wholly inside or wholly outside.
  // Clipping writes the line's own coordinate, hence the comparisons are exact.
  bool follows_block(const Vertices& piece, Index column, Index begin, Index end) const {
    const Vec2 low(grid_.x[column], grid_.y[begin]), high(grid_.x[column + 1], grid_.y[end]);
    for (std::size_t i = 0, j = piece.size() - 1; i < piece.size(); j = i++) {
      const Vec2 &a = piece[i], &b = piece[j];
      const bool along = (a.x() == b.x() && (a.x() == low.x() || a.x() == high.x())) ||
                         (a.y() == b.y() && (a.y() == low.y() || a.y() == high.y()));
      if (!along) return false;
    }
    return true;
  }

  const GridLines& grid_;
  const CellVisitor& visit_;
};

}  // namespace

GridLines make_grid(const Lattice& lattice, const Vertices& exterior, const std::vector<Vertices>& others, Real noise) {
  constexpr Real kHairline = 1e-6;  // of a cell: narrower strips belong to the cell beside them
  constexpr Real kMostCells = 1 << 30;
  const Box box = box_of(exterior);
  const Vec2 first = (box.low.cwiseQuotient(lattice.spacing).array() + kHairline).floor();
  const Vec2 last = (box.high.cwiseQuotient(lattice.spacing).array() - kHairline).ceil().max(first.array() + 1);
  const Real cells = (last - first).prod();
  if (!(cells <= kMostCells) || !(first.cwiseAbs().maxCoeff() <= kMostCells)) {
    throw Error(Issue{.status = Status::kLimit,
                      .object = ObjectKind::kProfile,
                      .value = cells,
                      .text = "the lattice would have " + number(cells) + " cells; at most " + number(kMostCells) +
                              " are possible: use a larger spacing"});
  }
  GridLines grid;
  grid.ix0 = static_cast<Index>(first.x());
  grid.iy0 = static_cast<Index>(first.y());
  grid.x = lines(grid.ix0, static_cast<Index>(last.x()), lattice.spacing.x());
  grid.y = lines(grid.iy0, static_cast<Index>(last.y()), lattice.spacing.y());
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<Real>& at = axis == 0 ? grid.x : grid.y;
    const Index begin = axis == 0 ? grid.ix0 : grid.iy0;
    const Real spacing = lattice.spacing[axis], tolerance = 1e-9 * spacing + noise;
    std::vector<bool> done(at.size(), false);
    snap(at, begin, spacing, axis, exterior, tolerance, done);
    for (const Vertices& polygon : others) snap(at, begin, spacing, axis, polygon, tolerance, done);
    at.front() = std::min(at.front(), box.low[axis]);
    at.back() = std::max(at.back(), box.high[axis]);
  }
  return grid;
}

void clip(const Vertices& polygon, int axis, Real at, bool keep_below, Vertices& out) {
  out.clear();
  const auto kept = [&](const Vec2& p) { return keep_below ? p[axis] <= at : p[axis] >= at; };
  const int other = 1 - axis;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &from = polygon[j], &to = polygon[i];
    if (kept(from) != kept(to) && from[axis] != at && to[axis] != at) {
      // Interpolated from the same end whichever way the edge runs, so that both halves get the same point.
      const bool swap = from[axis] > to[axis];
      const Vec2 &a = swap ? to : from, &b = swap ? from : to;
      Vec2 p;
      p[axis] = at;
      p[other] = a[other] + (b[other] - a[other]) * ((at - a[axis]) / (b[axis] - a[axis]));
      out.push_back(p);
    }
    if (kept(to)) out.push_back(to);
  }
}

void cut_by_grid(const Vertices& polygon, const GridLines& grid, const CellVisitor& visit) {
  Vertices inside = polygon, scratch;
  const auto keep = [&](int axis, Real at, bool below) {
    clip(inside, axis, at, below, scratch);
    inside.swap(scratch);
  };
  keep(0, grid.x.front(), false);
  keep(0, grid.x.back(), true);
  keep(1, grid.y.front(), false);
  keep(1, grid.y.back(), true);
  Cutter(grid, visit).columns(inside, 0, grid.columns());
}

}  // namespace vbgpd
