#include "geometry/walls.h"

#include <cmath>
#include <limits>
#include <tuple>

namespace vbgpd {
namespace {

constexpr Real kSlack = 1e-6;  // of a cell: round-off of cell centres against edges
constexpr Real kCorner = 0.7;  // cosine between the normals of two rollers: less is a corner, more a bend

int rank(Hold hold) { return hold == Hold::kFixed ? 0 : hold == Hold::kVelocity ? 1 : 2; }

struct WallCell {
  Index ix, iy;
  Real distance;  // from the edge
  const HeldEdge* edge;
};

class WallBuilder {
 public:
  WallBuilder(const Vertices& exterior, const std::vector<Seed>& soil, const Vec2& spacing, int reach)
      : exterior_(exterior), soil_(soil), index_(soil), spacing_(spacing), h_(spacing.minCoeff()), reach_(reach) {}

  void behind(const HeldEdge& edge) {
    if (std::abs(edge.normal.y()) < kSlack) beside_rows(edge);
    else if (std::abs(edge.b.x() - edge.a.x()) >= std::abs(edge.b.y() - edge.a.y())) along(edge, 0);
    else along(edge, 1);
  }

  // The wedge beyond both edges where one ends and the next begins.
  void corner(const HeldEdge& first, const HeldEdge& second) {
    const Vec2 p = first.b;
    const Vec2 in = first.b - first.a, out = second.b - second.a;
    const Index cx = column(p.x()), cy = row(p.y());
    for (Index ix = cx - reach_ - 1; ix <= cx + reach_ + 1; ++ix)
      for (Index iy = cy - reach_ - 1; iy <= cy + reach_ + 1; ++iy) {
        const Vec2 away = center(ix, iy) - p;
        if (away.dot(in) < 0 || away.dot(out) > 0 || !near(away)) continue;
        add(ix, iy, away.norm(), first);
        add(ix, iy, away.norm(), second);
      }
  }

  std::vector<Seed> seeds() {
    std::sort(cells_.begin(), cells_.end(), [&](const WallCell& a, const WallCell& b) {
      if (a.ix != b.ix) return a.ix < b.ix;
      if (a.iy != b.iy) return a.iy < b.iy;
      const auto key = [&](const WallCell& c) {
        return std::make_tuple(std::llround(c.distance / (h_ * kSlack)), rank(c.edge->hold), c.edge->boundary, c.edge);
      };
      return key(a) < key(b);
    });
    std::vector<Seed> result;
    for (const WallCell& cell : cells_) {
      if (result.empty() || result.back().ix != cell.ix || result.back().iy != cell.iy) result.push_back(seed(cell));
      else if (both_rollers(result.back(), *cell.edge)) result.back().hold = Hold::kFixed;
    }
    return result;
  }

 private:
  Index column(Real x) const { return static_cast<Index>(std::floor(x / spacing_.x())); }
  Index row(Real y) const { return static_cast<Index>(std::floor(y / spacing_.y())); }
  Vec2 center(Index ix, Index iy) const { return {(ix + 0.5) * spacing_.x(), (iy + 0.5) * spacing_.y()}; }

  // Within reach cells in x and in y (centres sit at half cells).
  bool near(const Vec2& away) const { return away.cwiseQuotient(spacing_).cwiseAbs().maxCoeff() < reach_ - kSlack; }

  void add(Index ix, Index iy, Real distance, const HeldEdge& edge) {
    if (index_.find(ix, iy) >= 0) return;
    if (contains(exterior_, center(ix, iy) + kSlack * h_ * edge.normal)) return;
    cells_.push_back({ix, iy, distance, &edge});
  }

  void try_cell(Index ix, Index iy, const HeldEdge& edge) {
    const Vec2 out = center(ix, iy) - edge.a, tangent = (edge.b - edge.a).normalized();
    const Real foot = out.dot(tangent), depth = out.dot(edge.normal), length = (edge.b - edge.a).norm();
    if (depth < -kSlack * h_ || foot < -kSlack * h_ || foot > length + kSlack * h_) return;
    if (near(depth * edge.normal)) add(ix, iy, std::max(depth, Real(0)), edge);
  }

  // Walks the cells along the longer axis of the edge, with room for the slant across it.
  void along(const HeldEdge& edge, int axis) {
    const int other = 1 - axis;
    const Real low = std::min(edge.a[axis], edge.b[axis]), high = std::max(edge.a[axis], edge.b[axis]);
    const Real slope = (edge.b[other] - edge.a[other]) / (edge.b[axis] - edge.a[axis]);
    const auto cell = [&](Real at, int k) { return static_cast<Index>(std::floor(at / spacing_[k])); };
    const Index room = 2 * reach_ + 2;
    for (Index i = cell(low, axis) - room; i <= cell(high, axis) + room; ++i) {
      const Real at = (i + 0.5) * spacing_[axis];
      const Index middle = cell(edge.a[other] + slope * (at - edge.a[axis]), other);
      for (Index j = middle - room; j <= middle + room; ++j) axis == 0 ? try_cell(i, j, edge) : try_cell(j, i, edge);
    }
  }

  void beside_rows(const HeldEdge& edge) {
    const Index step = edge.normal.x() > 0 ? 1 : -1;
    const Real x = edge.a.x(), low = std::min(edge.a.y(), edge.b.y()), high = std::max(edge.a.y(), edge.b.y());
    const Index inner = column(x - step * spacing_.x() / 2);
    for (Index iy = row(low + kSlack * spacing_.y()); iy <= row(high - kSlack * spacing_.y()); ++iy) {
      if (index_.find(inner, iy) < 0) continue;
      for (Index k = 1; k <= reach_ + 1; ++k) {
        const Real depth = step * (center(inner + step * k, iy).x() - x);
        if (depth > -kSlack * h_ && near(Vec2(depth, 0))) add(inner + step * k, iy, std::max(depth, Real(0)), edge);
      }
    }
  }

  // In the corner of two rollers each holds what the other lets slide.
  static bool both_rollers(const Seed& wall, const HeldEdge& edge) {
    return wall.hold == Hold::kRoller && edge.hold == Hold::kRoller && wall.normal.dot(edge.normal) < kCorner;
  }

  // First soil met when going back along the normal.
  Index along_normal(const WallCell& cell) const {
    const Vec2 start = center(cell.ix, cell.iy);
    for (int k = 1; k <= 4 * (reach_ + 2); ++k) {
      const Vec2 p = start - (k * 0.5 * h_) * cell.edge->normal;
      const Index found = index_.find(column(p.x()), row(p.y()));
      if (found >= 0) return found;
    }
    return -1;
  }

  Seed seed(const WallCell& cell) const {
    Seed wall{.ix = cell.ix, .iy = cell.iy, .volume = spacing_.prod()};
    wall.centroid = center(cell.ix, cell.iy);
    wall.hold = cell.edge->hold;
    wall.boundary = cell.edge->boundary;
    wall.normal = cell.edge->normal;
    Index source = wall.hold == Hold::kRoller ? along_normal(cell) : -1;
    if (source >= 0) wall.volume = soil_[source].volume;
    if (source < 0)
      source = nearest_seed(index_, cell.ix, cell.iy, 4 * (reach_ + 2), spacing_, [](Index) { return true; });
    if (source < 0) source = nearest_of_all(cell);
    if (source >= 0) wall.material = soil_[source].material, wall.layer = soil_[source].layer;
    return wall;
  }

  /// Soil thinner than a cell is merged into seeds that may stand far away.
  Index nearest_of_all(const WallCell& cell) const {
    Index nearest = -1;
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t k = 0; k < soil_.size(); ++k) {
      const Vec2 away(static_cast<Real>(soil_[k].ix - cell.ix), static_cast<Real>(soil_[k].iy - cell.iy));
      const Real distance = away.cwiseProduct(spacing_).squaredNorm();
      if (distance < least) least = distance, nearest = static_cast<Index>(k);
    }
    return nearest;
  }

  const Vertices& exterior_;
  const std::vector<Seed>& soil_;
  CellIndex index_;
  Vec2 spacing_;
  Real h_;
  Index reach_;
  std::vector<WallCell> cells_;
};

}  // namespace

std::vector<Seed> wall_seeds(const std::vector<HeldEdge>& edges, const Vertices& exterior,
                             const std::vector<Seed>& soil, const Vec2& spacing, int reach) {
  WallBuilder walls(exterior, soil, spacing, reach);
  for (const HeldEdge& edge : edges) walls.behind(edge);
  // Edges that start where another ends, found by sorting the starts by x.
  const Real same = 1e-6 * spacing.minCoeff();
  std::vector<const HeldEdge*> starts;
  for (const HeldEdge& edge : edges) starts.push_back(&edge);
  std::sort(starts.begin(), starts.end(), [](const HeldEdge* a, const HeldEdge* b) { return a->a.x() < b->a.x(); });
  for (const HeldEdge& edge : edges) {
    auto next = std::lower_bound(starts.begin(), starts.end(), edge.b.x() - same,
                                 [](const HeldEdge* e, Real x) { return e->a.x() < x; });
    for (; next != starts.end() && (*next)->a.x() <= edge.b.x() + same; ++next)
      if (((*next)->a - edge.b).norm() <= same) walls.corner(edge, **next);
  }
  return walls.seeds();
}

}  // namespace vbgpd
