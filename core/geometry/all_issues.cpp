#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "geometry/check.h"
#include "geometry/outline.h"
#include "geometry/polygon.h"
#include "geometry/section.h"
#include "geometry/thickness.h"
#include "scene/validate.h"
#include "scene/wording.h"

namespace vbgpd {

namespace {

/// The same fault seen twice: once as a value, once as a shape.
bool same_place(const Issue& a, const Issue& b) {
  return a.severity == Severity::kError && a.object == b.object && a.object_id == b.object_id && a.item == b.item;
}

void warn(ObjectKind object, std::int64_t id, double value, const std::string& text, std::vector<Issue>& issues) {
  Issue issue;
  issue.severity = Severity::kWarning, issue.status = Status::kOk, issue.object = object;
  issue.object_id = id, issue.value = value, issue.text = text;
  issues.push_back(std::move(issue));
}

void warn(std::size_t material, double value, const std::string& text, std::vector<Issue>& issues) {
  warn(ObjectKind::kMaterial, static_cast<std::int64_t>(material), value, text, issues);
}

/// Spacing of the lattice that a scene gets where it asks for that: within 10 % of it, so that edges fit.
Real fitted_spacing(const SceneDef& scene, Real asked) {
  constexpr int kMultiple = 2;  // of a strength reduction: the grid twice as coarse has the same edges
  return std::sqrt(fit_lattice(scene, asked, kMultiple).spacing.prod());
}

/// The largest spacing of two digits to ask for that gives at least so many cells over a thickness.
Real spacing_for(const SceneDef& scene, Real thickness, double cells) {
  const Real most = thickness / cells, unit = std::pow(10, std::floor(std::log10(most)) - 1);
  Real digits = std::floor(most / unit * (1 + 1e-9));
  const auto too_coarse = [&] { return fitted_spacing(scene, digits * unit) * cells > thickness * (1 + 1e-9); };
  for (const Real least = 0.8 * digits; digits > least && too_coarse();) --digits;
  return digits * unit;
}

/// A strength reduction also asks a grid twice as coarse, for its error estimate.
void warn_of_thin_soils(const SceneDef& scene, std::vector<Issue>& issues) {
  constexpr double kResolvedTwice = 2 * kResolvedCells, kRounding = 1 - 1e-9;
  if (scene.materials.size() < 2) return;
  const Real spacing = fitted_spacing(scene, scene.spacing);
  const std::vector<Real> thickness = material_thickness(scene, scene.spacing);
  for (std::size_t m = 0; m < thickness.size(); ++m) {
    const double cells = thickness[m] / spacing;
    if (!(cells < kRounding * kResolvedTwice)) continue;
    const bool unseen = cells < kRounding * kResolvedCells;
    const double asked = unseen ? kResolvedCells : kResolvedTwice;
    warn(m, thickness[m],
         "material '" + scene.materials[m].name + "' is " + number_text(thickness[m], 3) + " m thick, " +
             number_text(cells, 2) + " spacings; " +
             (unseen ? "the grid sees soil from " + number_text(asked) + " spacings on"
                     : "two grids, which an error estimate takes, need " + number_text(asked) +
                           ": the coarser one hardly sees it") +
             ": if it is weak, use a spacing of at most " + number_text(spacing_for(scene, thickness[m], asked), 2) +
             " m",
         issues);
  }
}

/// A slope of a few particles is none.
void warn_of_coarse_grid(const SceneDef& scene, std::vector<Issue>& issues) {
  constexpr Real kFew = 5, kEnough = 20;
  const Polygon exterior = counter_clockwise(scene.exterior);
  Real low = std::numeric_limits<Real>::infinity(), high = -low;
  for (const std::size_t k : outline_of(local(exterior, box_of(exterior).low)).ground)
    low = std::min(low, exterior[k].y), high = std::max(high, exterior[k].y);
  const Real cells = (high - low) / scene.spacing;
  if (!(cells > 1 && cells < kFew)) return;
  warn(ObjectKind::kProfile, -1, scene.spacing,
       "spacing = " + number_text(scene.spacing) + " m: the ground rises by " + number_text(cells, 2) +
           " spacings only; a factor of safety takes about " + number_text(kEnough) + ", a spacing of " +
           number_text((high - low) / kEnough, 2) + " m",
       issues);
}

void warn_of_unused_soils(const SceneDef& scene, std::vector<Issue>& issues) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const std::string& name = scene.materials[m].name;
    const auto uses = [&](const LayerDef& layer) { return layer.material == name; };
    if (std::none_of(scene.layers.begin(), scene.layers.end(), uses))
      warn(m, kNone, "materials[" + std::to_string(m) + "] '" + name + "': no layer is of this soil", issues);
  }
}

}  // namespace

std::vector<Issue> all_issues(const SceneDef& scene) {
  std::vector<Issue> issues = validate(scene);
  const std::size_t values = issues.size();
  for (Issue& shape : check_geometry(scene)) {
    const auto end = issues.begin() + static_cast<std::ptrdiff_t>(values);
    const bool known = std::any_of(issues.begin(), end, [&](const Issue& i) { return same_place(i, shape); });
    if (!known) issues.push_back(std::move(shape));
  }
  if (has_error(issues)) return issues;
  try {
    require_spacing(scene.spacing, box_of(counter_clockwise(scene.exterior)).size());
    warn_of_unused_soils(scene, issues);
    warn_of_thin_soils(scene, issues);
    warn_of_coarse_grid(scene, issues);
  } catch (const Error& error) {
    issues.push_back(error.issue());
  }
  return issues;
}

}  // namespace vbgpd
