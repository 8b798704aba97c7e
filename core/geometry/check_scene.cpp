#include "geometry/check_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/format.h"
#include "geometry/outline.h"
#include "geometry/paint.h"
#include "scene/wording.h"

namespace vbgpd {
namespace {

constexpr Real kArea = 1e-6;    // relative: areas of typed coordinates are no better
constexpr Real kLength = 1e-6;  // of the section's extent: a point this near lies on the exterior

Issue issue_of(Severity severity, ObjectKind object, std::size_t id) {
  Issue issue;
  issue.severity = severity;
  issue.status = Status::kGeometry;
  issue.object = object;
  issue.object_id = static_cast<std::int64_t>(id);
  return issue;
}

void put(Issue& issue, const Point& p) {
  issue.x = p.x;
  issue.y = p.y;
}

class LayerChecker {
 public:
  LayerChecker(const SceneDef& scene, const std::vector<bool>& sound, std::vector<Issue>& issues)
      : scene_(scene),
        sound_(sound),
        issues_(issues),
        origin_(box_of(scene.exterior).low),
        extent_(box_of(scene.exterior).extent()),
        exterior_(local(open_polygon(scene.exterior), origin_)) {}

  void run() {
    std::vector<Vertices> polygons;
    std::vector<std::size_t> layers;
    bool all_sound = true;
    for (std::size_t k = 0; k < scene_.layers.size(); ++k) {
      all_sound = all_sound && sound_[k];
      if (!sound_[k]) continue;
      polygons.push_back(local(open_polygon(scene_.layers[k].polygon), origin_));
      layers.push_back(k);
    }
    std::vector<const Vertices*> coats;
    for (const Vertices& polygon : polygons) coats.push_back(polygon.empty() ? nullptr : &polygon);
    const Painted painted = paint(exterior_, coats);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const bool inside = !coats[i] || check_inside(layers[i], polygons[i], painted.inside[i]);
      if (inside && all_sound && painted.visible[i] <= kArea * painted.inside[i]) painted_over(layers[i]);
    }
    if (all_sound && painted.bare > kArea * std::abs(signed_area(exterior_))) bare(painted);
  }

 private:
  // False when nothing of the layer is inside.
  bool check_inside(std::size_t layer, const Vertices& polygon, Real inside) {
    const Real area = std::abs(signed_area(polygon));
    if (inside > area * (1 - kArea)) return true;
    const bool wholly = inside <= kArea * area;
    Issue issue = issue_of(wholly ? Severity::kError : Severity::kWarning, ObjectKind::kLayer, layer);
    std::size_t vertex = 0;  // the first one outside; all may lie inside when only edges leave a concave exterior
    while (vertex < polygon.size() && (contains(exterior_, polygon[vertex]) || on_exterior(polygon[vertex]))) ++vertex;
    if (vertex == polygon.size() && wholly) vertex = 0;
    std::string where;
    if (vertex < polygon.size()) {
      issue.item = static_cast<std::int64_t>(vertex);
      put(issue, scene_.layers[layer].polygon[vertex]);
      where = ", for example at vertex " + std::to_string(vertex) + " " + place(issue.x, issue.y, extent_);
    }
    issue.value = area - inside;
    const Box box = box_of(scene_.exterior);
    issue.text = layer_title(scene_, layer) +
                 (wholly ? ": lies wholly outside the exterior" : ": lies partly outside the exterior") + where +
                 (wholly ? "; the exterior spans x " + coordinate(box.low.x(), extent_) + " to " +
                               coordinate(box.high.x(), extent_) + ", y " + coordinate(box.low.y(), extent_) + " to " +
                               coordinate(box.high.y(), extent_) + " and a layer must overlap it"
                         : "; the " + number(area - inside) + " m2 outside are ignored");
    issues_.push_back(issue);
    return !wholly;
  }

  bool on_exterior(const Vec2& p) const {
    for (std::size_t i = 0, j = exterior_.size() - 1; i < exterior_.size(); j = i++)
      if (distance_to_segment(p, exterior_[j], exterior_[i]) <= kLength * extent_) return true;
    return false;
  }

  void painted_over(std::size_t layer) {
    Issue issue = issue_of(Severity::kWarning, ObjectKind::kLayer, layer);
    issue.text =
        layer_title(scene_, layer) + ": is wholly painted over by later layers and has no effect; put it after them";
    issues_.push_back(issue);
  }

  void bare(const Painted& painted) {
    if (scene_.layers.empty()) return;  // said already
    Issue issue = issue_of(Severity::kError, ObjectKind::kProfile, 0);
    issue.object_id = -1;
    issue.value = painted.bare;
    put(issue, {painted.bare_place.x() + origin_.x(), painted.bare_place.y() + origin_.y()});
    issue.text = "layers: " + number(painted.bare) + " m2 of the exterior have no material, for example at " +
                 place(issue.x, issue.y, extent_) +
                 "; add a first layer without polygon to fill the exterior, or a polygon that covers this place";
    issues_.push_back(issue);
  }

  const SceneDef& scene_;
  const std::vector<bool>& sound_;
  std::vector<Issue>& issues_;
  Vec2 origin_;
  Real extent_;
  Vertices exterior_;
};

}  // namespace

std::string layer_title(const SceneDef& scene, std::size_t layer) {
  return "layers[" + std::to_string(layer) + "] '" + scene.layers[layer].material + "'";
}

void check_layers(const SceneDef& scene, const std::vector<bool>& sound, std::vector<Issue>& issues) {
  LayerChecker(scene, sound, issues).run();
}

void check_boundaries(const SceneDef& scene, std::vector<Issue>& issues) {
  const Box box = box_of(scene.exterior);
  const Real extent = box.extent();
  const Vertices exterior = local(scene.exterior, box.low);
  for (std::size_t k = 0; k < scene.boundaries.size(); ++k) {
    const BoundaryDef& boundary = scene.boundaries[k];
    for (std::size_t v = 0; v < boundary.polyline.size(); ++v) {
      const Point& p = boundary.polyline[v];
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;  // reported with the other numbers
      const Vec2 at(p.x - box.low.x(), p.y - box.low.y());
      Real distance = std::numeric_limits<Real>::infinity();
      for (std::size_t i = 0, j = exterior.size() - 1; i < exterior.size(); j = i++)
        distance = std::min(distance, distance_to_segment(at, exterior[j], exterior[i]));
      if (distance <= kLength * extent) continue;
      Issue issue = issue_of(Severity::kError, ObjectKind::kBoundary, k);
      issue.item = static_cast<std::int64_t>(v);
      put(issue, p);
      issue.value = distance;
      issue.text = "boundaries[" + std::to_string(k) + "]" + (boundary.name.empty() ? "" : " '" + boundary.name + "'") +
                   ": point " + std::to_string(v) + " at " + place(p.x, p.y, extent) + " touches nothing, it is " +
                   number(distance) + " m from the exterior; a boundary must run along the exterior";
      issues.push_back(issue);
    }
  }
}

void check_loads(const SceneDef& scene, std::vector<Issue>& issues) {
  const Box box = box_of(scene.exterior);
  const Real extent = box.extent(), left = box.low.x(), right = box.high.x(), slack = 1e-9 * extent;
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    const LoadDef& load = scene.loads[k];
    if (!std::isfinite(load.x0) || !std::isfinite(load.x1)) continue;  // reported with the other numbers
    Issue issue = issue_of(Severity::kError, ObjectKind::kLoad, k);
    const std::string title = "loads[" + std::to_string(k) + "]: ";
    const std::string range = coordinate(load.x0, extent) + " to " + coordinate(load.x1, extent);
    if (!(load.x0 < load.x1)) {
      issue.x = issue.value = load.x0;
      issue.text = title + "x0 must be less than x1, but the load goes from x = " + range;
      issues.push_back(issue);
    }
    if (std::min(load.x0, load.x1) >= left - slack && std::max(load.x0, load.x1) <= right + slack) continue;
    issue.x = issue.value =
        std::min(load.x0, load.x1) < left - slack ? std::min(load.x0, load.x1) : std::max(load.x0, load.x1);
    issue.text = title + "from x = " + range +
                 " is off the ground surface, which spans x = " + coordinate(left, extent) + " to " +
                 coordinate(right, extent) + "; x0 and x1 must lie within";
    issues.push_back(issue);
  }
}

void check_overlapping_loads(const SceneDef& scene, std::vector<Issue>& issues) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < scene.loads.size(); ++k)
    if (scene.loads[k].x0 < scene.loads[k].x1) order.push_back(k);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return scene.loads[k].x0; });
  for (std::size_t n = 1, farthest = 0; n < order.size(); ++n) {
    const LoadDef &before = scene.loads[order[farthest]], &load = scene.loads[order[n]];
    if (const double end = std::min(before.x1, load.x1); load.x0 < end) {
      const auto [lower, upper] = std::minmax(order[farthest], order[n]);
      Issue issue = issue_of(Severity::kWarning, ObjectKind::kLoad, upper);
      issue.status = Status::kRange, issue.value = load.x0;
      issue.text = "loads[" + std::to_string(upper) + "]: stands on loads[" + std::to_string(lower) +
                   "] from x = " + number_text(load.x0) + " to " + number_text(end) + " m: their pressures add";
      issues.push_back(issue);
    }
    if (load.x1 > before.x1) farthest = n;
  }
}

void check_standing_water(const SceneDef& scene, std::vector<Issue>& issues) {
  const std::vector<Point>& table = scene.water_table;
  if (table.size() < 2) return;
  for (std::size_t k = 0; k < table.size(); ++k)  // reported with the other numbers
    if (!std::isfinite(table[k].x) || !std::isfinite(table[k].y) || (k > 0 && !(table[k].x > table[k - 1].x))) return;
  const Polygon exterior = counter_clockwise(scene.exterior);
  const Box box = box_of(exterior);
  std::vector<Point> ground;
  std::vector<Real> places;
  for (const std::size_t k : outline_of(local(exterior, box.low)).ground)
    ground.push_back(exterior[k]), places.push_back(exterior[k].x);
  for (const Point& p : table)
    if (p.x > box.low.x() && p.x < box.high.x()) places.push_back(p.x);
  std::sort(places.begin(), places.end());
  const auto depth = [&](Real x) { return height_at(table, x) - height_at(ground, x); };
  const Real tolerated = 0.02 * box.size().y();
  const auto report = [&](Real from, Real to, Real low, Real high) {
    if (!(high - low > tolerated)) return;
    Issue issue = issue_of(Severity::kWarning, ObjectKind::kProfile, 0);
    issue.object_id = -1, issue.status = Status::kRange, issue.x = from, issue.value = high - low;
    const Real extent = box.extent();
    issue.text = "water: the table stands above the ground from x = " + coordinate(from, extent) + " to " +
                 coordinate(to, extent) + ", between y = " + coordinate(low, extent) + " and " +
                 coordinate(high, extent) + ": water that stands is level; draw it level there, or below the ground";
    issues.push_back(issue);
  };
  Real from = 0, to = 0, low = 0, high = 0;
  bool wet = false;
  const auto reach = [&](Real x) {
    const Real level = height_at(table, x);
    if (!wet) from = x, low = high = level;
    wet = true, to = x, low = std::min(low, level), high = std::max(high, level);
  };
  for (std::size_t k = 1; k < places.size(); ++k) {  // between two places the depth is linear
    const Real a = places[k - 1], b = places[k], da = depth(a), db = depth(b);
    const auto shore = [&] { return a + (b - a) * da / (da - db); };
    if (da > 0 || db > 0) reach(da < 0 ? shore() : a), reach(db < 0 ? shore() : b);
    if (!wet || db > 0) continue;
    report(from, to, low, high);
    wet = false;
  }
  if (wet) report(from, to, low, high);
}

}  // namespace vbgpd
