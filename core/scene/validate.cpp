#include "scene/validate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "base/types.h"
#include "scene/limits.h"
#include "scene/names.h"
#include "scene/properties.h"
#include "scene/quantity.h"
#include "scene/wording.h"

namespace vbgpd {
namespace {

constexpr std::array<std::string_view, 3> kSides{"base", "left", "right"};
constexpr int kPointsReported = 10;  // of one polygon; a file of garbage coordinates needs no million messages

std::string quoted(std::string_view text) { return std::string("\"").append(text).append("\""); }

std::string range_text(const Property& p, Units units) {
  const auto end = [&](double v) { return number_text(in_units(v, p.unit, units)); };
  const bool below = std::isfinite(p.min_value), above = std::isfinite(p.max_value);
  if (below && above)
    return std::string("in ") + (p.min_open ? "(" : "[") + end(p.min_value) + ", " + end(p.max_value) +
           (p.max_open ? ")" : "]");
  return (p.min_open ? "> " : ">= ") + end(p.min_value);
}

bool in_range(const Property& p, double v) {
  return (p.min_open ? v > p.min_value : v >= p.min_value) && (p.max_open ? v < p.max_value : v <= p.max_value);
}

/// Gathers the issues of one object after the other; `label` starts every sentence: materials[2] 'clay'.
class Report {
 public:
  explicit Report(Units units) : units(units) {}

  const Units units;
  std::vector<Issue> issues;

  void about(ObjectKind object, std::int64_t id, std::string label) {
    object_ = object, id_ = id, label_ = std::move(label);
  }

  Issue& add(Severity severity, Status status, double value, const std::string& text) {
    Issue issue;
    issue.severity = severity, issue.status = status, issue.object = object_, issue.object_id = id_;
    issue.value = value;
    issue.text = label_ + ": " + text;
    return issues.emplace_back(std::move(issue));
  }
  Issue& error(Status status, const std::string& text, double value = kNone) {
    return add(Severity::kError, status, value, text);
  }
  void warn(const std::string& text, double value = kNone) { add(Severity::kWarning, Status::kRange, value, text); }

  void name(std::string_view field, std::string_view value, std::span<const std::string_view> known) {
    for (const auto candidate : known)
      if (candidate == value) return;
    error(Status::kUnknownName, std::string(field) + " " + quoted(value) + " is not known: use one of " +
                                    list_text(known) + suggestion_text(value, known));
  }

 private:
  ObjectKind object_ = ObjectKind::kNone;
  std::int64_t id_ = -1;
  std::string label_;
};

std::string label(const char* list, std::size_t i, const std::string& name) {
  return std::string(list) + "[" + std::to_string(i) + "]" + (name.empty() ? "" : " '" + name + "'");
}

std::string range_hint(const Property& p, double v) {
  const std::string_view name = p.name;
  if (name == "poisson_ratio" && v >= 0.5) return "; use 0.49 for undrained soil";
  if (name == "kh" || name == "kv") return "; it is a fraction of the weight";
  return {};
}

/// Text that a file of the scene could not hold (limits.h).
void check_text(const std::string& text, const char* field, Report& report) {
  if (text.size() > kMaxTextBytes)
    report.error(Status::kRange,
                 std::string(field) + " has " + std::to_string(text.size()) + " bytes of text: at most " +
                     std::to_string(kMaxTextBytes) + " are accepted",
                 static_cast<double>(text.size()));
  if (const std::size_t control = control_in(text); control != text.npos)
    report.error(Status::kArgument, std::string(field) + " holds a control character at byte " +
                                        std::to_string(control) + ": names are plain text");
}

void check_count(std::size_t count, std::size_t most, const char* list, Report& report) {
  if (count <= most) return;
  report.about(ObjectKind::kProfile, -1, list);
  report.error(Status::kRange,
               "the list has " + std::to_string(count) + " entries: at most " + std::to_string(most) + " are accepted",
               static_cast<double>(count));
}

/// Missing, not finite or out of range: everything the property table says about one object.
void check_numbers(const SceneDef& scene, ObjectKind object, std::int64_t id, Report& report) {
  for (const Property& p : properties()) {
    if (p.object != object) continue;
    const double v = *find_property(scene, object, id, p.name);
    const std::string name = p.name;
    if (std::isnan(v) && p.required) {
      report.error(Status::kArgument,
                   name + " is missing: a number in" + unit_text(p.unit, report.units) + " is needed. " + p.doc);
    } else if (std::isnan(v) && std::isnan(p.default_value)) {
      continue;  // left out
    } else if (!std::isfinite(v)) {
      report.error(Status::kRange, name + " = " + number_text(v) + ": must be a finite number", v);
    } else if (!in_range(p, v)) {
      report.error(Status::kRange,
                   name + " = " + quantity_text(v, p.unit, report.units) + ": must be " + range_text(p, report.units) +
                       range_hint(p, v),
                   v);
    }
  }
}

/// Vertices without a repeated last one.
std::size_t corner_count(const Polygon& polygon) {
  const bool closed =
      polygon.size() > 1 && polygon.front().x == polygon.back().x && polygon.front().y == polygon.back().y;
  return polygon.size() - closed;
}

void check_points(const Polygon& points, const std::string& name, Report& report) {
  int reported = 0;
  for (std::size_t i = 0; i < points.size() && reported < kPointsReported; ++i) {
    const Point& p = points[i];
    if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
    const bool x_bad = !std::isfinite(p.x);
    Issue& issue = report.error(Status::kRange,
                                name + "[" + std::to_string(i) + "]." + (x_bad ? "x" : "y") + " = " +
                                    number_text(x_bad ? p.x : p.y) + ": must be a finite number",
                                x_bad ? p.x : p.y);
    issue.item = static_cast<std::int64_t>(i);
    issue.x = p.x, issue.y = p.y;
    if (++reported == kPointsReported) issue.text += " (further points of this list are not reported)";
  }
}

void check_corners(const Polygon& polygon, const std::string& name, Report& report) {
  if (const std::size_t n = corner_count(polygon); n < 3) {
    const std::string corners = std::to_string(n) + (n == 1 ? " vertex" : " vertices");
    report.error(Status::kGeometry, name + " has " + corners + ": an area needs at least 3").item = 0;
  }
  check_points(polygon, name, report);
}

void check_friction_angle(double angle, const char* owner, Report& report) {
  const std::string name = "friction_angle = " + number_text(angle) + " degrees ";
  if (angle > 0 && angle <= 1.6)
    report.warn(
        name + "looks like radians: " + number_text(angle) + " rad is " + number_text(angle * 180 / kPi) + " degrees",
        angle);
  if (angle > 60 && angle < 90) report.warn(name + "is more than any " + owner + " has: 15 to 45 is usual", angle);
}

/// Values that are allowed but look like a slip of units.
void check_plausible(const MaterialDef& m, Report& report) {
  const Units units = report.units;
  const bool kilo = units == Units::kKilopascal;
  const auto warn = [&](const char* name, double v, const char* unit, const std::string& text) {
    if (std::isfinite(v)) report.warn(std::string(name) + " = " + quantity_text(v, unit, units) + " " + text, v);
  };
  const auto usual = [&](double from, double to, const char* unit) {
    return number_text(in_units(from, unit, units)) + " to " + number_text(in_units(to, unit, units)) + " is usual";
  };
  if (m.unit_weight >= 1 && m.unit_weight < 1000)
    warn("unit_weight", m.unit_weight, "N m-3",
         kilo ? "is less than any soil weighs: " + usual(15000, 25000, "N m-3")
              : "looks like " + number_text(m.unit_weight) + " kN/m3: with units SI write " +
                    number_text(1000 * m.unit_weight) + ", or set units to kPa");
  if (kilo && m.unit_weight >= 1e6 && m.unit_weight < 5e6)
    warn("unit_weight", m.unit_weight, "N m-3",
         "looks like a density of " + number_text(m.unit_weight / 1000) + " kg/m3: with units kPa write the weight, " +
             number_text(m.unit_weight * 9.81e-6, 3) + " kN/m3");
  else if (kilo && m.unit_weight >= 5e6)
    warn("unit_weight", m.unit_weight, "N m-3",
         "looks like " + number_text(m.unit_weight / 1000) + " N/m3: with units kPa write " +
             number_text(m.unit_weight / 1e6) + ", or set units to SI");
  else if (m.unit_weight >= 1000 && m.unit_weight < 5000)
    warn("unit_weight", m.unit_weight, "N m-3",
         "is less than any soil weighs: " + usual(15000, 25000, "N m-3") + "; if a density of " +
             number_text(kilo ? m.unit_weight / 1000 : m.unit_weight) + (kilo ? " t/m3" : " kg/m3") +
             " is meant, write the weight, " + quantity_text(m.unit_weight * 9.81, "N m-3", units, 3));
  else if (m.unit_weight > 50000)
    warn("unit_weight", m.unit_weight, "N m-3", "is more than any soil weighs: " + usual(15000, 25000, "N m-3"));
  if (m.saturated_unit_weight < m.unit_weight)
    warn("saturated_unit_weight", m.saturated_unit_weight, "N m-3",
         "is less than unit_weight: soil full of water is no lighter");
  check_friction_angle(m.friction_angle, "soil", report);
  if (m.friction_angle == 0 && m.dilatancy_angle == 0 && m.cohesion > 0 && (m.law == "mohr_coulomb" || m.law == "drucker_prager"))
    report.warn("friction_angle = 0 with law " + quoted(m.law) +
                    ": if it was forgotten, give it; soil without friction is law \"undrained\"",
                0);
  if (m.cohesion > 2e6)
    warn("cohesion", m.cohesion, "Pa",
         kilo ? "is that of rock; if " + number_text(m.cohesion / 1000) + " Pa is meant, set units to SI"
              : "is that of rock");
  if (m.cohesion >= 1 && m.cohesion < 200 && !kilo)
    warn("cohesion", m.cohesion, "Pa",
         "is next to nothing; if " + number_text(m.cohesion) + " kPa are meant, write " +
             number_text(1000 * m.cohesion) + " Pa or set units to kPa");
  if (m.young_modulus > 0 && m.young_modulus < 1e4)
    warn("young_modulus", m.young_modulus, "Pa", "is softer than any soil: " + usual(1e6, 1e9, "Pa"));
}

void check_strength(const MaterialDef& m, Report& report) {
  if (!yields(m)) return;
  if (std::isnan(m.cohesion))
    report.error(Status::kArgument, "cohesion is missing: law " + quoted(m.law) + " needs it (" +
                                        unit_text("Pa", report.units).substr(1) + ", 0 is allowed with friction)");
  if (m.friction_angle >= 0 && m.dilatancy_angle > m.friction_angle)  // else told of friction_angle itself
    report.error(Status::kRange,
                 "dilatancy_angle = " + number_text(m.dilatancy_angle) +
                     " degrees: must not exceed friction_angle = " + number_text(m.friction_angle) + " degrees" +
                     (m.friction_angle == 0 ? ", which is what it is when not given" : ""),
                 m.dilatancy_angle);
  if (m.cohesion_gradient > 0 && std::isnan(m.cohesion_datum))
    report.error(Status::kArgument,
                 "cohesion_gradient = " + quantity_text(m.cohesion_gradient, "Pa m-1", report.units) +
                     " needs cohesion_datum, the elevation below which cohesion grows");
  if (m.law == "undrained") {
    if (m.friction_angle > 0)
      report.error(Status::kRange,
                   "friction_angle = " + number_text(m.friction_angle) +
                       " degrees: law \"undrained\" has cohesion only; use law \"mohr_coulomb\" for soil with friction",
                   m.friction_angle);
  } else if (m.cohesion_gradient > 0) {
    report.error(Status::kUnsupported,
                 "cohesion_gradient = " + quantity_text(m.cohesion_gradient, "Pa m-1", report.units) +
                     ": only law \"undrained\" has cohesion that grows with depth");
  }
  if (m.cohesion == 0 && m.friction_angle == 0 && !(m.cohesion_gradient > 0))
    report.error(Status::kRange, "cohesion = 0 and friction_angle = 0: soil without any strength cannot stand", 0);
  const double apex = m.cohesion / std::tan(radians(m.friction_angle));
  if (m.friction_angle > 0 && m.tension_cutoff > apex)
    report.warn("tension_cutoff = " + quantity_text(m.tension_cutoff, "Pa", report.units) +
                    " has no effect: the apex of the cone, cohesion / tan(friction_angle), is at " +
                    quantity_text(apex, "Pa", report.units),
                m.tension_cutoff);
}

void check_materials(const SceneDef& scene, Report& report) {
  if (scene.materials.empty()) {
    report.about(ObjectKind::kMaterial, -1, "materials");
    report.error(Status::kArgument, "the list is empty: a scene needs at least one soil");
  }
  std::map<std::string_view, std::size_t> first_of_name;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const MaterialDef& m = scene.materials[i];
    const auto id = static_cast<std::int64_t>(i);
    report.about(ObjectKind::kMaterial, id, label("materials", i, m.name));
    if (m.name.empty()) report.error(Status::kArgument, "name is missing: layers refer to a soil by its name");
    if (const auto [at, fresh] = first_of_name.emplace(m.name, i); !fresh && !m.name.empty())
      report.error(Status::kArgument,
                   "the name is already that of materials[" + std::to_string(at->second) + "]: names must differ");
    check_text(m.name, "name", report);
    report.name("law", m.law, kLawNames);
    check_numbers(scene, ObjectKind::kMaterial, id, report);
    check_strength(m, report);
    check_plausible(m, report);
  }
}

void check_layers(const SceneDef& scene, Report& report) {
  if (scene.layers.empty()) {
    report.about(ObjectKind::kLayer, -1, "layers");
    report.error(Status::kArgument,
                 "the list is empty: a layer with a material and no polygon fills the whole exterior");
  }
  std::vector<std::string_view> names;
  for (const MaterialDef& m : scene.materials) names.push_back(m.name);
  for (std::size_t i = 0; i < scene.layers.size(); ++i) {
    const LayerDef& layer = scene.layers[i];
    report.about(ObjectKind::kLayer, static_cast<std::int64_t>(i), label("layers", i, layer.material));
    if (layer.material.empty()) report.error(Status::kArgument, "material is missing: name one of " + list_text(names));
    else report.name("material", layer.material, names);
    if (!layer.polygon.empty()) check_corners(layer.polygon, "polygon", report);
  }
}

void check_boundaries(const SceneDef& scene, Report& report) {
  for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
    const BoundaryDef& b = scene.boundaries[i];
    const auto id = static_cast<std::int64_t>(i);
    report.about(ObjectKind::kBoundary, id, label("boundaries", i, b.name.empty() ? b.side : b.name));
    check_text(b.name, "name", report);
    if (b.side.empty() && b.polyline.empty())
      report.error(Status::kArgument,
                   "where is missing: give side (" + list_text(kSides) + ") or a polyline along the exterior");
    if (!b.side.empty() && !b.polyline.empty())
      report.error(Status::kArgument, "side and polyline are both given: keep the one that is meant");
    if (!b.side.empty()) report.name("side", b.side, kSides);
    if (b.polyline.size() == 1) report.error(Status::kGeometry, "polyline has 1 point: a line needs at least 2");
    check_points(b.polyline, "polyline", report);
    check_numbers(scene, ObjectKind::kBoundary, id, report);
    if (b.kind != BoundaryKind::kVelocity && (b.vx != 0 || b.vy != 0))
      report.warn("vx and vy have no effect: only a boundary of kind \"velocity\" moves");
    if (std::isnan(b.friction_angle)) continue;
    check_friction_angle(b.friction_angle, "base", report);
    const std::string friction = "friction_angle = " + number_text(b.friction_angle) + " degrees ";
    if (b.kind == BoundaryKind::kFixed)
      report.warn(friction + "acts in a run-out only: until then, and in a strength reduction, the boundary is fixed",
                  b.friction_angle);
    else
      report.warn(friction + "has no effect: only on a boundary of kind \"fixed\" soil can slide by friction",
                  b.friction_angle);
  }
}

/// A section that nothing holds up falls; kh that points into the slope makes it safer.
void check_rest(const SceneDef& scene, Report& report) {
  const auto holds_up = [](const BoundaryDef& b) {
    if (b.kind == BoundaryKind::kFree) return false;
    if (b.kind != BoundaryKind::kRoller) return true;
    if (b.polyline.size() < 2) return b.side == "base";
    return std::any_of(b.polyline.begin(), b.polyline.end(),
                       [&](const Point& p) { return p.x != b.polyline.front().x; });
  };
  report.about(ObjectKind::kProfile, -1, "boundaries");
  const bool weightless = scene.kv <= -0.999;
  if (!scene.boundaries.empty() && !weightless &&
      std::none_of(scene.boundaries.begin(), scene.boundaries.end(), holds_up))
    report.warn(
        "nothing holds the section up, so that it will fall: fix its base, or leave the list of boundaries out");
  if (scene.kh == 0 || scene.exterior.size() < 3) return;
  double left = scene.exterior[0].x, right = left, low = scene.exterior[0].y, high = low;
  for (const Point& p : scene.exterior)
    left = std::min(left, p.x), right = std::max(right, p.x), low = std::min(low, p.y), high = std::max(high, p.y);
  double top_left = low, top_right = low;
  for (const Point& p : scene.exterior) {
    if (p.x == left) top_left = std::max(top_left, p.y);
    if (p.x == right) top_right = std::max(top_right, p.y);
  }
  const double fall = top_left - top_right;  // towards +x
  report.about(ObjectKind::kProfile, -1, "scene");
  if (fall * scene.kh < -0.1 * (high - low) * std::fabs(scene.kh))
    report.warn(
        "kh = " + number_text(scene.kh) + " pushes the soil " + (scene.kh > 0 ? "to the right" : "to the left") +
            ", away from the low side of the section; the slope is the less safe with " + number_text(-scene.kh),
        scene.kh);
}

void check_loads(const SceneDef& scene, Report& report) {
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const LoadDef& load = scene.loads[i];
    const auto id = static_cast<std::int64_t>(i);
    report.about(ObjectKind::kLoad, id, label("loads", i, ""));
    check_numbers(scene, ObjectKind::kLoad, id, report);
    if (load.x0 >= load.x1)
      report.error(Status::kRange,
                   "x0 = " + number_text(load.x0) + " m: must be left of x1 = " + number_text(load.x1) + " m", load.x0);
    if (load.pressure < 0 || load.pressure_end < 0)
      report.warn("a negative pressure pulls the ground up: loads are positive downwards",
                  load.pressure < 0 ? load.pressure : load.pressure_end);
    constexpr double kHeavy = 5e6;
    if (const double most = std::fmax(load.pressure, load.pressure_end); most > kHeavy)
      report.warn(
          "a pressure of " + quantity_text(most, "Pa", scene.units) + " is more than any foundation puts on soil" +
              (scene.units == Units::kKilopascal ? "; if " + number_text(most / 1000) + " Pa is meant, set units to SI"
                                                 : ""),
          most);
  }
}

/// Points from left to right over the whole section.
void check_water(const SceneDef& scene, Report& report) {
  report.about(ObjectKind::kProfile, -1, "water");
  const Polygon& table = scene.water_table;
  if (!table.empty() && !(scene.water_unit_weight > 9e3 && scene.water_unit_weight < 12e3))
    report.warn("water_unit_weight = " + quantity_text(scene.water_unit_weight, "N m-3", scene.units) +
                    ": water weighs " + quantity_text(9810, "N m-3", scene.units),
                scene.water_unit_weight);
  for (const MaterialDef& m : scene.materials)
    if (!table.empty() && m.pore_pressure_ratio > 0)
      report.warn("the pore pressure of '" + m.name +
                      "' is that of its pore_pressure_ratio; the water table does not count there",
                  m.pore_pressure_ratio);
  if (table.empty()) {
    for (const MaterialDef& m : scene.materials)
      if (!std::isnan(m.saturated_unit_weight))
        report.warn("there is no water table, so that the saturated_unit_weight of '" + m.name + "' is never used",
                    m.saturated_unit_weight);
    return;
  }
  if (table.size() < 2) {
    report.error(Status::kArgument, "the water table has one point: give at least two, from left to right");
    return;
  }
  int reported = 0;
  for (std::size_t i = 0; i < table.size() && reported < kPointsReported; ++i) {
    const std::string point = label("table", i, "") + ": ";
    if (!std::isfinite(table[i].x) || !std::isfinite(table[i].y))
      report.error(Status::kRange, point + "x and y must be finite numbers of m"), ++reported;
    else if (i > 0 && table[i].x <= table[i - 1].x)
      report.error(Status::kRange,
                   point + "x = " + number_text(table[i].x) +
                       " m: must be right of x = " + number_text(table[i - 1].x) + " m of the point before",
                   table[i].x),
          ++reported;
  }
  if (reported > 0 || scene.exterior.empty()) return;
  const auto by_x = [](const Point& a, const Point& b) { return a.x < b.x; };
  const auto [left, right] = std::minmax_element(scene.exterior.begin(), scene.exterior.end(), by_x);
  const double slack = 1e-9 * (right->x - left->x);
  if (table.front().x > left->x + slack)
    report.error(Status::kRange,
                 "the water table begins at x = " + number_text(table.front().x) +
                     " m: add a point at or left of the left end of the section, x = " + number_text(left->x) + " m",
                 table.front().x);
  if (table.back().x < right->x - slack)
    report.error(Status::kRange,
                 "the water table ends at x = " + number_text(table.back().x) +
                     " m: add a point at or right of the right end of the section, x = " + number_text(right->x) + " m",
                 table.back().x);
}

void check_settings(const SceneDef& scene, Report& report) {
  report.about(ObjectKind::kProfile, -1, "scene");
  check_text(scene.name, "name", report);
  check_text(scene.source, "source", report);
  check_numbers(scene, ObjectKind::kProfile, -1, report);
  report.name("bond", scene.bond, kBondNames);
  report.name("kernel", scene.kernel, kKernelNames);
  const auto& search = scene.strength_reduction;
  if (search.srf_max <= search.srf_min)
    report.error(
        Status::kRange,
        "srf_max = " + number_text(search.srf_max) + ": must be greater than srf_min = " + number_text(search.srf_min),
        search.srf_max);
}

void check_published(const SceneDef& scene, Report& report) {
  for (std::size_t i = 0; i < scene.published.size(); ++i) {
    const PublishedValue& value = scene.published[i];
    report.about(ObjectKind::kProfile, -1, label("published", i, value.method));
    check_text(value.method, "method", report);
    check_text(value.source, "source", report);
    const bool end_bad = std::isinf(value.factor_of_safety_end);
    if (!std::isfinite(value.factor_of_safety) || end_bad)
      report.error(Status::kRange, std::string(end_bad ? "factor_of_safety_end" : "factor_of_safety") + " = " +
                                       number_text(end_bad ? value.factor_of_safety_end : value.factor_of_safety) +
                                       ": must be a finite number");
  }
}

}  // namespace

std::vector<Issue> validate(const SceneDef& scene) {
  Report report(scene.units);
  report.about(ObjectKind::kProfile, -1, "profile");
  check_corners(scene.exterior, "exterior", report);
  check_count(scene.materials.size(), kMaxSoils, "materials", report);
  check_count(scene.layers.size(), kMaxObjects, "layers", report);
  check_count(scene.boundaries.size(), kMaxObjects, "boundaries", report);
  check_count(scene.loads.size(), kMaxObjects, "loads", report);
  check_materials(scene, report);
  check_layers(scene, report);
  check_boundaries(scene, report);
  check_rest(scene, report);
  check_loads(scene, report);
  check_water(scene, report);
  check_settings(scene, report);
  check_published(scene, report);
  return std::move(report.issues);
}

bool has_error(const std::vector<Issue>& issues) {
  for (const Issue& issue : issues)
    if (issue.severity == Severity::kError) return true;
  return false;
}

}  // namespace vbgpd
