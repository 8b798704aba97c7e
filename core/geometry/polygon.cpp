#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vbgpd {
namespace {

bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

const Vec2& vec(const Vec2& p) { return p; }
Vec2 vec(const Point& p) { return {p.x, p.y}; }

template <class Corners>
bool surrounded(const Corners& polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = vec(polygon[i]), b = vec(polygon[j]);
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * ((p.y() - a.y()) / (b.y() - a.y()))) inside = !inside;
  }
  return inside;
}

}  // namespace

Box box_of(const Vertices& polygon) {
  Box box;
  if (polygon.empty()) return box;
  box.low = box.high = polygon.front();
  for (const Vec2& p : polygon) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Box box_of(const Polygon& polygon) { return box_of(local(polygon, Vec2::Zero())); }

Polygon open_polygon(const Polygon& polygon) {
  Polygon open = polygon;
  while (open.size() > 1 && same(open.front(), open.back())) open.pop_back();
  return open;
}

Polygon counter_clockwise(const Polygon& polygon) {
  Polygon result = open_polygon(polygon);
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  if (result.size() >= 3 && signed_area(local(result, box_of(result).low)) < 0)
    std::reverse(result.begin(), result.end());
  return result;
}

Vertices local(const Polygon& polygon, const Vec2& origin) {
  Vertices result;
  result.reserve(polygon.size());
  for (const Point& p : polygon) result.emplace_back(p.x - origin.x(), p.y - origin.y());
  return result;
}

Real signed_area(const Vertices& polygon) { return moments_of(polygon).area; }

Moments moments_of(const Vertices& polygon) {
  Moments sum;
  if (polygon.size() < 3) return sum;
  // Fan of triangles about the first vertex: small differences of coordinates instead of large products.
  const Vec2 apex = polygon.front();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - apex, b = polygon[i + 1] - apex;
    const Real area = cross(a, b) / 2;
    sum.area += area;
    sum.first += area / 3 * (a + b);
  }
  sum.first += sum.area * apex;
  return sum;
}

bool contains(const Vertices& polygon, const Vec2& p) { return surrounded(polygon, p); }
bool contains(const Polygon& polygon, const Vec2& p) { return surrounded(polygon, p); }

bool is_convex(const Vertices& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = polygon[(i + 1) % n] - polygon[i], out = polygon[(i + 2) % n] - polygon[(i + 1) % n];
    if (cross(in, out) < -1e-9 * in.norm() * out.norm()) return false;
  }
  return true;
}

Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const Real length2 = ab.squaredNorm();
  const Real t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, Real(0), Real(1)) : Real(0);
  return a + t * ab;
}

Real distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  return (nearest_on_segment(p, a, b) - p).norm();
}

Real coordinate_noise(const Box& scene_box) {
  const Real largest = std::max(scene_box.low.cwiseAbs().maxCoeff(), scene_box.high.cwiseAbs().maxCoeff());
  return 4 * std::numeric_limits<Real>::epsilon() * largest;
}

}  // namespace vbgpd
