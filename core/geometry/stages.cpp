#include "geometry/stages.h"

#include <algorithm>
#include <cmath>

#include "geometry/cut_pairs.h"
#include "geometry/outline.h"

namespace vbgpd {
namespace {

/// An edge that is not vertical, from left to right.
struct Edge {
  Vec2 a, b;
  bool outer;  ///< of the exterior
  Real at(Real x) const {
    if (x <= a.x()) return a.y();
    return x >= b.x() ? b.y() : a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x()));
  }
};

/// The upper and the lower rim of the soil that is left, both from left to right, in the local frame.
struct Rims {
  Vertices top, bottom;
};

/// Cuts the section into upright slabs, within each of which the same edges lie over one another.
class Slabs {
 public:
  Slabs(const SceneDef& scene, const Layers& layers, const Vertices& exterior, const Vec2& origin)
      : map_(scene), layers_(layers), exterior_(exterior), origin_(origin), same_(1e-9 * box_of(exterior).extent()) {
    add(exterior, true);
    for (const LayerDef& layer : scene.layers) add(local(counter_clockwise(layer.polygon), origin), false);
    for (std::size_t i = 0; i < edges_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) add_crossing(edges_[i], edges_[j]);
    std::sort(places_.begin(), places_.end());
  }

  Rims rims() const {
    const Box box = box_of(exterior_);
    Rims rims;
    Real left = box.low.x();
    for (Real right : places_) {
      if (right <= left + same_ || right > box.high.x() + same_) continue;
      add_slab(left, right, rims);
      left = right;
    }
    straighten(rims.top), straighten(rims.bottom);
    return rims;
  }

 private:
  void add(const Vertices& polygon, bool outer) {
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const Vec2 &a = polygon[j], &b = polygon[i];
      places_.push_back(b.x());
      if (a.x() != b.x()) edges_.push_back(a.x() < b.x() ? Edge{a, b, outer} : Edge{b, a, outer});
    }
  }

  void add_crossing(const Edge& e, const Edge& f) {
    const Real low = std::max(e.a.x(), f.a.x()), high = std::min(e.b.x(), f.b.x());
    if (!(low < high)) return;
    const Real before = e.at(low) - f.at(low), after = e.at(high) - f.at(high);
    if (before * after < 0) places_.push_back(low + (high - low) * (before / (before - after)));
  }

  bool soil(Real x, Real y) const {
    if (!contains(exterior_, Vec2(x, y))) return false;
    return has_layer(layers_, map_.at(x + origin_.x(), y + origin_.y()));
  }

  void add_slab(Real left, Real right, Rims& rims) const {
    const Real middle = (left + right) / 2;
    std::vector<const Edge*> over;
    for (const Edge& e : edges_)
      if (e.a.x() < middle && e.b.x() > middle) over.push_back(&e);
    std::sort(over.begin(), over.end(), [&](const Edge* e, const Edge* f) { return e->at(middle) < f->at(middle); });
    const Edge *top = nullptr, *bottom = nullptr, *floor = nullptr;
    for (std::size_t k = 0; k < over.size(); ++k) {
      if (over[k]->outer && floor == nullptr) floor = over[k];
      if (k + 1 == over.size()) break;
      const Real low = over[k]->at(middle), high = over[k + 1]->at(middle);
      if (high - low <= same_ || !soil(middle, (low + high) / 2)) continue;
      top = over[k + 1];
      if (bottom == nullptr) bottom = over[k];
    }
    if (top == nullptr) top = bottom = floor;  // all of it is gone: the bare floor
    if (top == nullptr) return;
    for (Real x : {left, right}) push(rims.top, Vec2(x, top->at(x))), push(rims.bottom, Vec2(x, bottom->at(x)));
  }

  void push(Vertices& chain, const Vec2& p) const {
    if (chain.empty() || (chain.back() - p).norm() > same_) chain.push_back(p);
  }

  void straighten(Vertices& chain) const {
    Vertices kept;
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (kept.empty() || i + 1 == chain.size() || distance_to_segment(chain[i], kept.back(), chain[i + 1]) > same_)
        kept.push_back(chain[i]);
    chain = std::move(kept);
  }

  LayerMap map_;
  const Layers& layers_;
  const Vertices& exterior_;
  Vec2 origin_;
  Real same_;
  std::vector<Edge> edges_;
  std::vector<Real> places_;
};

Real ground_height(const std::vector<Point>& ground, const Box& box) {
  const auto [toe, crest] =
      std::minmax_element(ground.begin(), ground.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  const Real height = crest->y - toe->y;
  return height > 1e-9 * box.extent() ? height : box.size().y();
}

/// Pairs cut among the seeds that are there, by their places among all seeds.
std::vector<CutPair> present_cut_pairs(const Vertices& exterior, const std::vector<HeldEdge>& held,
                                       const Section& section, Real support) {
  std::vector<Seed> present;
  Vertices places;
  std::vector<Index> number;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    if (!section.seeds[k].active) continue;
    present.push_back(section.seeds[k]), places.push_back(section.local_place(k));
    number.push_back(static_cast<Index>(k));
  }
  std::vector<CutPair> pairs = cut_pairs(exterior, held, present, places, section.lattice.spacing, support);
  for (CutPair& p : pairs) p = {number[static_cast<std::size_t>(p.a)], number[static_cast<std::size_t>(p.b)]};
  return pairs;
}

}  // namespace

LayerMap::LayerMap(const SceneDef& scene) : origin_(box_of(scene.exterior).low) {
  for (const LayerDef& layer : scene.layers) polygons_.push_back(local(open_polygon(layer.polygon), origin_));
}

Index LayerMap::at(Real x, Real y) const {
  const Vec2 p = Vec2(x, y) - origin_;
  for (std::size_t k = polygons_.size(); k-- > 0;)
    if (polygons_[k].empty() || contains(polygons_[k], p)) return static_cast<Index>(k);
  return -1;
}

void keep_layers(const SceneDef& scene, const Layers& layers, Section& section) {
  const Vec2 origin = section.lattice.origin;
  const Polygon outline = counter_clockwise(scene.exterior);
  const Vertices whole = local(outline, origin);
  const std::vector<HeldEdge> held = held_edges(section.boundaries, whole, origin);
  const Real support = 2 * scene.smoothing_ratio;
  Section made;
  made.lattice = section.lattice, made.seeds = section.seeds, made.shifts = section.shifts;
  bool all = true, any = false;
  for (Seed& seed : made.seeds) {
    seed.active = has_layer(layers, seed.layer);
    if (seed.hold != Hold::kFree) continue;
    made.area += seed.active ? seed.volume : 0;
    (seed.active ? any : all) = seed.active;
  }
  if (!any && !all)
    throw Error(Status::kArgument, "no soil would be left: at least one layer with soil must stay switched on");
  if (all) {
    made.exterior = outline, made.area = signed_area(whole);
    for (std::size_t i : outline_of(whole).ground) made.ground.push_back(outline[i]);
    made.cut_pairs = present_cut_pairs(whole, held, made, support);
  } else {
    const auto moved = [&](const Vec2& p) { return Point{p.x() + origin.x(), p.y() + origin.y()}; };
    Rims rims = Slabs(scene, layers, whole, origin).rims();
    for (const Vec2& p : rims.top) made.ground.push_back(moved(p));
    Vertices left = rims.bottom;
    left.insert(left.end(), rims.top.rbegin(), rims.top.rend());
    for (const Vec2& p : left) made.exterior.push_back(moved(p));
    made.exterior = counter_clockwise(made.exterior);
    made.cut_pairs = present_cut_pairs(local(made.exterior, origin), held, made, support);
  }
  section.height = ground_height(made.ground, box_of(made.exterior));
  section.area = made.area;
  section.seeds = std::move(made.seeds), section.cut_pairs = std::move(made.cut_pairs);
  section.exterior = std::move(made.exterior), section.ground = std::move(made.ground);
}

}  // namespace vbgpd
