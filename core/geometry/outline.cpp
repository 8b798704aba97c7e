#include "geometry/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbgpd {
namespace {

constexpr Real kSame = 1e-9;  // of the section's extent: points nearer than this are one point

// Follows the exterior counter-clockwise, both ends included.
std::vector<std::size_t> walk(std::size_t from, std::size_t to, std::size_t count) {
  std::vector<std::size_t> chain{from};
  while (from != to) chain.push_back(from = (from + 1) % count);
  return chain;
}

// A place on the exterior: edge number plus the distance from its first vertex, both counter-clockwise.
struct Place {
  std::size_t edge = 0;
  Real along = 0;
};

class Perimeter {
 public:
  explicit Perimeter(const Vertices& exterior) : vertices_(exterior), start_(exterior.size() + 1, 0) {
    for (std::size_t i = 0; i < exterior.size(); ++i) start_[i + 1] = start_[i] + (vertex(i + 1) - vertex(i)).norm();
  }

  Place nearest(const Vec2& p) const {
    Place best;
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Real distance = distance_to_segment(p, vertex(i), vertex(i + 1));
      if (distance >= least) continue;
      least = distance;
      const Vec2 edge = vertex(i + 1) - vertex(i);
      best = {i, std::clamp((p - vertex(i)).dot(edge) / edge.norm(), Real(0), edge.norm())};
    }
    return best;
  }

  /// Points from one place to another by the shorter way, in counter-clockwise order.
  Vertices between(const Place& p, const Place& q) const {
    const Real total = start_.back();
    const Real forward = std::fmod(station(q) - station(p) + total, total);
    return forward <= total - forward ? ahead(p, q, forward) : ahead(q, p, total - forward);
  }

 private:
  const Vec2& vertex(std::size_t i) const { return vertices_[i % vertices_.size()]; }
  Real station(const Place& p) const { return start_[p.edge] + p.along; }
  Vec2 point(const Place& p) const {
    return vertex(p.edge) + p.along * (vertex(p.edge + 1) - vertex(p.edge)).normalized();
  }

  Vertices ahead(const Place& p, const Place& q, Real length) const {
    const Real total = start_.back();
    Vertices chain{point(p)};
    for (std::size_t k = 1; k <= vertices_.size(); ++k) {
      const std::size_t i = (p.edge + k) % vertices_.size();
      if (std::fmod(start_[i] - station(p) + 2 * total, total) >= length) break;
      chain.push_back(vertex(i));
    }
    chain.push_back(point(q));
    return chain;
  }

  const Vertices& vertices_;
  std::vector<Real> start_;
};

Hold hold_of(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::kFixed:
      return Hold::kFixed;
    case BoundaryKind::kRoller:
      return Hold::kRoller;
    case BoundaryKind::kVelocity:
      return Hold::kVelocity;
    case BoundaryKind::kFree:
      break;
  }
  return Hold::kFree;
}

class Holder {
 public:
  Holder(const Vertices& exterior, const Vec2& origin)
      : exterior_(exterior),
        origin_(origin),
        outline_(outline_of(exterior)),
        perimeter_(exterior),
        extent_(box_of(exterior).extent()) {}

  void hold(const BoundaryDef& boundary, Index index) {
    const Hold hold = hold_of(boundary.kind);
    if (hold == Hold::kFree) return;
    const auto edge = [&](const Vec2& a, const Vec2& b) { add(a, b, hold, index); };
    const auto edge_from = [&](std::size_t i) { edge(exterior_[i], exterior_[(i + 1) % exterior_.size()]); };
    if (boundary.side == "base")
      for (std::size_t k = 0; k + 1 < outline_.base.size(); ++k) edge_from(outline_.base[k]);
    if (boundary.side == "left")
      for (std::size_t i : outline_.left) edge_from(i);
    if (boundary.side == "right")
      for (std::size_t i : outline_.right) edge_from(i);
    const Vertices points = local(boundary.polyline, origin_);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const Vertices chain = perimeter_.between(perimeter_.nearest(points[k]), perimeter_.nearest(points[k + 1]));
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) edge(chain[i], chain[i + 1]);
    }
  }

  std::vector<HeldEdge> edges;

 private:
  void add(const Vec2& a, const Vec2& b, Hold hold, Index index) {
    const Vec2 along = b - a;
    const Real length = along.norm();
    if (length <= kSame * extent_) return;
    edges.push_back({a, b, Vec2(along.y(), -along.x()) / length, hold, index});
  }

  const Vertices& exterior_;
  Vec2 origin_;
  Outline outline_;
  Perimeter perimeter_;
  Real extent_;
};

}  // namespace

Outline outline_of(const Vertices& exterior) {
  const Box box = box_of(exterior);
  const Real tolerance = kSame * box.extent();
  const std::size_t n = exterior.size();
  const auto at_end = [&](std::size_t i, Real x) { return std::abs(exterior[i % n].x() - x) <= tolerance; };
  // The highest (sign 1) or lowest (sign -1) vertex at one end.
  const auto corner = [&](Real x, Real sign) {
    std::size_t best = n;
    for (std::size_t i = 0; i < n; ++i)
      if (at_end(i, x) && (best == n || sign * exterior[i].y() > sign * exterior[best].y())) best = i;
    return best;
  };
  const auto side = [&](std::size_t from, std::size_t to, Real x) {
    std::vector<std::size_t> edges;
    const std::vector<std::size_t> chain = walk(from, to, n);
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      if (at_end(chain[k], x) && at_end(chain[k + 1], x)) edges.push_back(chain[k]);
    return edges;
  };
  const Real x0 = box.low.x(), x1 = box.high.x();
  const std::size_t top_left = corner(x0, 1), low_left = corner(x0, -1);
  const std::size_t top_right = corner(x1, 1), low_right = corner(x1, -1);
  Outline outline;
  outline.ground = walk(top_right, top_left, n);
  outline.ground = {outline.ground.rbegin(), outline.ground.rend()};
  outline.base = walk(low_left, low_right, n);
  outline.left = side(top_left, low_left, x0);
  outline.right = side(low_right, top_right, x1);
  return outline;
}

Real height_at(const std::vector<Point>& line, Real x) {
  const auto right = std::find_if(line.begin(), line.end(), [&](const Point& p) { return p.x >= x; });
  if (right == line.begin()) return right->y;
  const Point& a = *(right - 1);
  if (right == line.end()) return a.y;
  return a.y + (right->y - a.y) * (x - a.x) / (right->x - a.x);
}

std::vector<BoundaryDef> boundaries_of(const SceneDef& scene) {
  if (!scene.boundaries.empty()) return scene.boundaries;
  std::vector<BoundaryDef> usual(3);
  usual[0].name = usual[0].side = "base";
  usual[1].name = usual[1].side = "left";
  usual[2].name = usual[2].side = "right";
  usual[1].kind = usual[2].kind = BoundaryKind::kRoller;
  return usual;
}

std::vector<HeldEdge> held_edges(const std::vector<BoundaryDef>& boundaries, const Vertices& exterior,
                                 const Vec2& origin) {
  Holder holder(exterior, origin);
  for (std::size_t i = 0; i < boundaries.size(); ++i) holder.hold(boundaries[i], static_cast<Index>(i));
  return std::move(holder.edges);
}

}  // namespace vbgpd
