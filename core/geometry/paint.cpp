#include "geometry/paint.h"

#include <algorithm>

namespace vbgpd {
namespace {

constexpr int kExterior = -1;

// A non-vertical edge from left to right.
struct Edge {
  Vec2 left, right;
  int owner;
  Real at(Real x) const {
    const Real t = (x - left.x()) / (right.x() - left.x());
    return left.y() + t * (right.y() - left.y());
  }
};

void add_edges(const Vertices& polygon, int owner, std::vector<Edge>& edges) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[j], &b = polygon[i];
    if (a.x() < b.x()) edges.push_back({a, b, owner});
    if (b.x() < a.x()) edges.push_back({b, a, owner});
  }
}

// Abscissae where two edges of different owners cross; edges sorted by their left end.
void add_crossings(const std::vector<Edge>& edges, std::vector<Real>& breaks) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].left.x() < edges[i].right.x(); ++j) {
      const Edge &e = edges[i], &f = edges[j];
      if (e.owner == f.owner) continue;
      const Real x0 = f.left.x(), x1 = std::min(e.right.x(), f.right.x());
      const Real gap0 = e.at(x0) - f.at(x0), gap1 = e.at(x1) - f.at(x1);
      if ((gap0 < 0 && gap1 > 0) || (gap0 > 0 && gap1 < 0)) breaks.push_back(x0 + (x1 - x0) * (gap0 / (gap0 - gap1)));
    }
}

struct Span {
  Real y0, y1;  // heights at both sides of the slab
  int owner;
};

class Slab {
 public:
  Slab(Painted& result, std::size_t layers, bool background)
      : result_(result), inside_(layers, 0), background_(background) {}

  // Adds the trapezoids between neighbouring edges of one slab.
  void add(Real x0, Real x1, std::vector<Span>& spans, const std::vector<char>& fills) {
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.y0 + a.y1 < b.y0 + b.y1; });
    std::fill(inside_.begin(), inside_.end(), 0);
    bool in_exterior = false;
    for (std::size_t k = 0; k + 1 < spans.size(); ++k) {
      if (spans[k].owner == kExterior) in_exterior = !in_exterior;
      else inside_[spans[k].owner] ^= 1;
      if (!in_exterior) continue;
      const Real area = (x1 - x0) * (spans[k + 1].y0 - spans[k].y0 + spans[k + 1].y1 - spans[k].y1) / 2;
      if (area > 0) count(area, Vec2((x0 + x1) / 2, middle(spans[k], spans[k + 1])), fills);
    }
  }

 private:
  static Real middle(const Span& a, const Span& b) { return (a.y0 + a.y1 + b.y0 + b.y1) / 4; }

  void count(Real area, const Vec2& place, const std::vector<char>& fills) {
    bool covered = false;
    for (std::size_t k = inside_.size(); k-- > 0;) {
      if (!inside_[k] && !(background_ && fills[k])) continue;
      result_.inside[k] += area;
      if (!covered) result_.visible[k] += area;
      covered = true;
    }
    if (covered) return;
    result_.bare += area;
    if (area > largest_bare_) {
      largest_bare_ = area;
      result_.bare_place = place;
    }
  }

  Painted& result_;
  std::vector<char> inside_;
  bool background_;
  Real largest_bare_ = 0;
};

}  // namespace

Painted paint(const Vertices& exterior, const std::vector<const Vertices*>& layers) {
  Painted result;
  result.inside.assign(layers.size(), 0);
  result.visible.assign(layers.size(), 0);
  std::vector<Edge> edges;
  add_edges(exterior, kExterior, edges);
  std::vector<char> fills(layers.size(), 0);
  bool background = false;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    fills[k] = layers[k] == nullptr;
    background = background || fills[k];
    if (layers[k]) add_edges(*layers[k], static_cast<int>(k), edges);
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.left.x() < b.left.x(); });

  std::vector<Real> breaks;
  for (const Edge& e : edges) breaks.insert(breaks.end(), {e.left.x(), e.right.x()});
  add_crossings(edges, breaks);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());

  Slab slab(result, layers.size(), background);
  std::vector<const Edge*> active;
  std::vector<Span> spans;
  std::size_t next = 0;
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
    const Real x0 = breaks[b], x1 = breaks[b + 1];
    std::erase_if(active, [&](const Edge* e) { return e->right.x() <= x0; });
    for (; next < edges.size() && edges[next].left.x() <= x0; ++next) active.push_back(&edges[next]);
    spans.clear();
    for (const Edge* e : active) spans.push_back({e->at(x0), e->at(x1), e->owner});
    slab.add(x0, x1, spans, fills);
  }
  return result;
}

}  // namespace vbgpd
