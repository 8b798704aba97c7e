#include "geometry/soil.h"

#include <cmath>

#include "geometry/format.h"

namespace vbgpd {
namespace {

// Net length of the outline along the cell's edges. Clipping bridges run to and fro and cancel.
std::array<Real, 4> contacts(const Vertices& outline, const Vec2& low, const Vec2& high) {
  std::array<Real, 4> length{};
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vec2 &a = outline[j], &b = outline[i];
    if (a.x() == b.x() && a.x() == low.x()) length[0] += a.y() - b.y();
    if (a.x() == b.x() && a.x() == high.x()) length[1] += b.y() - a.y();
    if (a.y() == b.y() && a.y() == low.y()) length[2] += b.x() - a.x();
    if (a.y() == b.y() && a.y() == high.y()) length[3] += a.x() - b.x();
  }
  return length;
}

[[noreturn]] void too_many(std::int64_t max_particles, Real cells, const Vec2& spacing) {
  throw Error(Issue{.status = Status::kLimit,
                    .object = ObjectKind::kProfile,
                    .value = cells,
                    .text = "spacings of " + number(spacing.x()) + " m and " + number(spacing.y()) + " m need about " +
                            number(cells) + " soil particles, more than the " + std::to_string(max_particles) +
                            " allowed: use a larger spacing or allow more particles"});
}

}  // namespace

Soil cut_soil(const Vertices& exterior, const GridLines& grid, const Vec2& spacing, std::int64_t max_particles) {
  Soil soil;
  const Real cell = spacing.prod(), area = signed_area(exterior);
  std::int64_t kept = 0;
  const auto count = [&](std::int64_t more) {
    kept += more;
    if (max_particles > 0 && kept > max_particles) too_many(max_particles, area / cell, spacing);
  };
  const auto corner = [&](Index column, Index row) { return Vec2(grid.x[column], grid.y[row]); };
  CellVisitor visit;
  visit.full = [&](Index column, Index begin, Index end) {
    count(end - begin);
    for (Index row = begin; row < end; ++row) {
      const Vec2 low = corner(column, row), high = corner(column + 1, row + 1);
      Seed seed{.ix = grid.ix0 + column, .iy = grid.iy0 + row, .volume = (high - low).prod()};
      seed.centroid = (low + high) / 2;
      soil.seeds.push_back(seed);
      soil.cut_of.push_back(-1);
    }
  };
  visit.partly = [&](Index column, Index row, const Vertices& outline) {
    const Moments moments = moments_of(outline);
    if (!(moments.area > 0)) return;
    if (moments.area > 0.51 * cell) count(1);
    const Vec2 low = corner(column, row), high = corner(column + 1, row + 1);
    Seed seed{.ix = grid.ix0 + column, .iy = grid.iy0 + row, .volume = moments.area};
    seed.centroid = (moments.first / moments.area).cwiseMax(low).cwiseMin(high);
    soil.seeds.push_back(seed);
    soil.cut_of.push_back(static_cast<Index>(soil.cut.size()));
    soil.cut.push_back({outline, contacts(outline, low, high)});
  };
  cut_by_grid(exterior, grid, visit);
  return soil;
}

}  // namespace vbgpd
