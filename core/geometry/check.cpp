#include "geometry/check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/check_scene.h"
#include "geometry/format.h"
#include "geometry/polygon.h"
#include "geometry/predicates.h"

namespace vbgpd {
namespace {

constexpr int kMostCrossings = 1000;  // per polygon: more than a person reads, and memory stays bounded

// Areas and moments, cubes of coordinates, must not overflow.
bool usable(Real coordinate) { return std::abs(coordinate) <= 1e100; }

// An edge between distinct vertices; from and to are the indices the user knows.
struct Edge {
  Segment segment;
  std::size_t from, to;
  Real left() const { return std::min(segment.from.x(), segment.to.x()); }
  Real right() const { return std::max(segment.from.x(), segment.to.x()); }
};

// The faults of one polygon on its own.
class PolygonChecker {
 public:
  PolygonChecker(const Polygon& polygon, std::string title, ObjectKind object, std::int64_t id, Real extent,
                 std::vector<Issue>& issues)
      : polygon_(open_polygon(polygon)),
        title_(std::move(title)),
        object_(object),
        id_(id),
        extent_(extent),
        issues_(issues) {}

  /// True when the polygon has no fault.
  bool run() {
    const std::size_t before = issues_.size();
    if (finite()) {
      repeated();
      scale();
      collect_distinct();
      if (points_.size() < 3) too_few();
      else if (collinear()) no_area();
      else if (!is_simple(points_)) crossings(issues_.size() > before);
    }
    return issues_.size() == before;
  }

 private:
  void report(std::size_t vertex, const Point& at, Real value, const std::string& text) {
    Issue issue;
    issue.status = Status::kGeometry;
    issue.object = object_;
    issue.object_id = id_;
    issue.item = static_cast<std::int64_t>(vertex);
    issue.x = at.x;
    issue.y = at.y;
    issue.value = value;
    issue.text = title_ + ": " + text;
    issues_.push_back(std::move(issue));
  }

  bool finite() {
    bool all = true;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Point& p = polygon_[i];
      if (usable(p.x) && usable(p.y)) continue;
      all = false;
      report(i, p, usable(p.x) ? p.y : p.x,
             "vertex " + std::to_string(i) + " is (" + number(p.x) + ", " + number(p.y) +
                 "); coordinates must be finite numbers between -1e100 and 1e100");
    }
    return all;
  }

  void repeated() {
    std::map<std::pair<Real, Real>, std::size_t> seen;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Point& p = polygon_[i];
      const auto [first, is_new] = seen.emplace(std::make_pair(p.x, p.y), i);
      if (!is_new)
        report(i, p, kNone,
               "vertices " + std::to_string(first->second) + " and " + std::to_string(i) + " are the same point " +
                   place(p.x, p.y, extent_) + "; every vertex must be given once");
    }
    distinct_ = seen.size();
  }

  // Powers of two change no predicate, and keep the constructed crossing points clear of under- and overflow.
  void scale() {
    Real largest = 0;
    for (const Point& p : polygon_) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    std::frexp(largest, &exponent_);
  }

  Point as_given(const Vec2& p) const { return {std::ldexp(p.x(), exponent_), std::ldexp(p.y(), exponent_)}; }

  // Vertices without repeats in a row: those are reported already and have no edge of their own.
  void collect_distinct() {
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Vec2 p(std::ldexp(polygon_[i].x, -exponent_), std::ldexp(polygon_[i].y, -exponent_));
      if (!points_.empty() && points_.back() == p) continue;
      points_.push_back(p);
      index_.push_back(i);
    }
    while (points_.size() > 1 && points_.front() == points_.back()) {
      points_.pop_back();
      index_.pop_back();
    }
    if (distinct_ < 3) points_.resize(std::min(points_.size(), distinct_));
  }

  void too_few() {
    report(0, polygon_.empty() ? Point{kNone, kNone} : polygon_[0], static_cast<Real>(distinct_),
           "has " + std::to_string(distinct_) + " distinct vertices; a polygon needs at least 3");
  }

  bool collinear() const {
    return std::all_of(points_.begin() + 2, points_.end(),
                       [&](const Vec2& p) { return orientation(points_[0], points_[1], p) == 0; });
  }

  void no_area() {
    report(0, polygon_[0], 0,
           "all vertices lie on one line through " + place(polygon_[0].x, polygon_[0].y, extent_) +
               ", so it encloses no area; move at least one vertex off the line");
  }

  std::vector<Edge> edges() const {
    std::vector<Edge> result;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::size_t j = (i + 1) % points_.size();
      result.push_back({{points_[i], points_[j]}, index_[i], index_[j]});
    }
    std::sort(result.begin(), result.end(), [](const Edge& a, const Edge& b) { return a.left() < b.left(); });
    return result;
  }

  // Every pair of edges that meet elsewhere than at a common vertex; edges sorted by their left end to skip distant
  // ones.
  void crossings(bool has_repeats) {
    std::vector<Issue> found;
    issues_.swap(found);
    const std::vector<Edge> all = edges();
    int count = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size() && all[j].left() <= all[i].right(); ++j)
        if (meeting(all[i].segment, all[j].segment).any && ++count <= kMostCrossings) crossing(all[i], all[j]);
    issues_.swap(found);
    std::sort(found.begin(), found.end(),
              [](const Issue& a, const Issue& b) { return a.item != b.item ? a.item < b.item : a.value < b.value; });
    for (Issue& issue : found) issues_.push_back(std::move(issue));
    if (found.empty() && !has_repeats)
      report(0, polygon_[0], kNone, "its edges touch each other; a polygon must not touch itself");
  }

  void crossing(const Edge& a, const Edge& b) {
    const Edge &e = a.from < b.from ? a : b, &f = a.from < b.from ? b : a;
    const Meeting common = meeting(e.segment, f.segment);
    if (common.piece) return overlap(e, f, common);
    const Vec2& p = common.from;
    const bool end_of_e = p == e.segment.from || p == e.segment.to;
    const bool end_of_f = p == f.segment.from || p == f.segment.to;
    if (end_of_e && end_of_f) return;  // neighbours, or a repeated vertex reported as such
    if (touches(e, f) || touches(f, e)) return;
    const Point at = as_given(p);
    report(e.from, at, static_cast<Real>(f.from),
           "edges " + std::to_string(e.from) + " and " + std::to_string(f.from) + " cross at " +
               place(at.x, at.y, extent_) + "; a polygon must not cross itself");
  }

  // Does f end exactly on e? Reported once per vertex, by the edge that starts there.
  bool touches(const Edge& e, const Edge& f) {
    if (!on_segment(f.segment.from, e.segment)) return on_segment(f.segment.to, e.segment);
    const Point& at = polygon_[f.from];
    report(f.from, at, static_cast<Real>(e.from),
           "vertex " + std::to_string(f.from) + " lies on edge " + std::to_string(e.from) + " at " +
               place(at.x, at.y, extent_) + "; a polygon must not touch itself");
    return true;
  }

  void overlap(const Edge& e, const Edge& f, const Meeting& common) {
    const Point from = as_given(common.from), to = as_given(common.to);
    report(e.from, from, static_cast<Real>(f.from),
           "edges " + std::to_string(e.from) + " and " + std::to_string(f.from) + " run over each other from " +
               place(from.x, from.y, extent_) + " to " + place(to.x, to.y, extent_) +
               "; a polygon must not touch itself");
  }

  Polygon polygon_;
  std::string title_;
  ObjectKind object_;
  std::int64_t id_;
  Real extent_;
  std::vector<Issue>& issues_;
  std::size_t distinct_ = 0;
  int exponent_ = 0;
  Vertices points_;
  std::vector<std::size_t> index_;  // per point: its number in the polygon as given
};

bool all_usable(const Polygon& polygon) {
  return std::all_of(polygon.begin(), polygon.end(), [](const Point& p) { return usable(p.x) && usable(p.y); });
}

// A section so small that its areas would underflow.
bool too_small(Real extent, std::vector<Issue>& issues) {
  if (extent >= 1e-100) return false;
  Issue issue;
  issue.status = Status::kGeometry;
  issue.object = ObjectKind::kProfile;
  issue.value = extent;
  issue.text = "profile.exterior: is " + number(extent) + " m in size; it must be at least 1e-100 m";
  issues.push_back(issue);
  return true;
}

}  // namespace

std::vector<Issue> check_geometry(const SceneDef& scene) {
  std::vector<Issue> issues;
  const bool measurable = all_usable(scene.exterior) && scene.exterior.size() >= 2;
  const Real extent = measurable ? box_of(scene.exterior).extent() : 0;
  const bool exterior_sound =
      PolygonChecker(scene.exterior, "profile.exterior", ObjectKind::kProfile, -1, extent, issues).run();
  std::vector<bool> sound;
  for (std::size_t k = 0; k < scene.layers.size(); ++k) {
    const Polygon& polygon = scene.layers[k].polygon;
    sound.push_back(polygon.empty() || PolygonChecker(polygon, layer_title(scene, k), ObjectKind::kLayer,
                                                      static_cast<std::int64_t>(k), extent, issues)
                                           .run());
  }
  if (exterior_sound && !too_small(extent, issues)) check_layers(scene, sound, issues);
  if (measurable) check_boundaries(scene, issues);
  if (measurable) check_loads(scene, issues);
  check_overlapping_loads(scene, issues);
  if (exterior_sound) check_standing_water(scene, issues);
  return issues;
}

}  // namespace vbgpd
