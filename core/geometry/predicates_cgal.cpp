// The only file that includes CGAL: kernel and Polygon_2, its LGPL parts.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include "geometry/predicates.h"

namespace vbgpd {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 exact(const Vec2& p) { return {p.x(), p.y()}; }

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  return static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(c)));
}

bool is_simple(const Vertices& polygon) {
  std::vector<Kernel::Point_2> points;
  for (const Vec2& p : polygon) points.push_back(exact(p));
  return CGAL::is_simple_2(points.begin(), points.end(), Kernel());
}

bool checks_with_cgal() noexcept { return true; }

}  // namespace vbgpd
