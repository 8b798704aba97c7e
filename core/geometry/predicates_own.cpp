// Exact predicates without CGAL. The determinant of an orientation is a sum of six products of doubles; every product
// and every sum is split into a rounded value and its exact error, so that the sum is kept exactly as an expansion of
// doubles that do not overlap (Shewchuk, Discrete & Computational Geometry 18, 1997). Round to nearest is needed and
// products must not underflow: hence the range of coordinates in predicates.h.
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/predicates.h"

namespace vbgpd {

namespace {

struct Split {
  double value, error;  // value + error is exact
};

Split two_sum(double a, double b) {
  const double s = a + b, bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

Split two_product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

/// Non-overlapping doubles, smallest first, whose sum is exact.
class Expansion {
 public:
  void add(double x) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Split s = two_sum(x, terms_[i]);
      x = s.value;
      if (s.error != 0) terms_[kept++] = s.error;
    }
    if (x != 0) terms_[kept++] = x;
    size_ = kept;
  }
  void add_product(double a, double b) {
    const Split p = two_product(a, b);
    add(p.error);
    add(p.value);
  }
  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0 ? 1 : -1); }

 private:
  std::array<double, 12> terms_{};
  std::size_t size_ = 0;
};

struct Edge {
  Segment segment;
  std::size_t index;
  Real left() const { return std::min(segment.from.x(), segment.to.x()); }
  Real right() const { return std::max(segment.from.x(), segment.to.x()); }
};

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  // the rounded determinant decides when it exceeds its own error
  const Real left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  constexpr Real kError = 4 * 1.1102230246251565e-16;  // (3 + 16 eps) eps, rounded up
  const Real rounded = left - right;
  if (std::fabs(rounded) > kError * (std::fabs(left) + std::fabs(right))) return rounded > 0 ? 1 : -1;
  Expansion exact;  // ax by - ay bx + bx cy - by cx + cx ay - cy ax
  exact.add_product(a.x(), b.y()), exact.add_product(-a.y(), b.x());
  exact.add_product(b.x(), c.y()), exact.add_product(-b.y(), c.x());
  exact.add_product(c.x(), a.y()), exact.add_product(-c.y(), a.x());
  return exact.sign();
}

bool is_simple(const Vertices& polygon) {
  const std::size_t n = polygon.size();
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < n; ++i) edges.push_back({{polygon[i], polygon[(i + 1) % n]}, i});
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.left() < b.left(); });
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n && edges[j].left() <= edges[i].right(); ++j) {
      const Edge &e = edges[i], &f = edges[j];
      const Meeting m = meeting(e.segment, f.segment);
      if (!m.any) continue;
      const bool follows = (e.index + 1) % n == f.index, leads = (f.index + 1) % n == e.index;
      const Vec2& common = follows ? e.segment.to : f.segment.to;
      if (m.piece || !(follows || leads) || m.from != common) return false;
    }
  return true;
}

bool checks_with_cgal() noexcept { return false; }

}  // namespace vbgpd
