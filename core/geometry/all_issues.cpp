#include <algorithm>
#include <iterator>

#include "geometry/check.h"
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

void warn(std::size_t material, double value, const std::string& text, std::vector<Issue>& issues) {
  Issue issue;
  issue.severity = Severity::kWarning, issue.status = Status::kOk, issue.object = ObjectKind::kMaterial;
  issue.object_id = static_cast<std::int64_t>(material), issue.value = value, issue.text = text;
  issues.push_back(std::move(issue));
}

/// A strength reduction also asks a grid twice as coarse, for its error estimate.
void warn_of_thin_soils(const SceneDef& scene, std::vector<Issue>& issues) {
  constexpr double kResolvedTwice = 2 * kResolvedCells, kRounding = 1 - 1e-9;
  if (scene.materials.size() < 2) return;
  const std::vector<Real> thickness = material_thickness(scene, scene.spacing);
  for (std::size_t m = 0; m < thickness.size(); ++m) {
    const double cells = thickness[m] / scene.spacing;
    if (!(cells < kRounding * kResolvedTwice)) continue;
    const bool unseen = cells < kRounding * kResolvedCells;
    const double asked = unseen ? kResolvedCells : kResolvedTwice;
    warn(m, thickness[m],
         "material '" + scene.materials[m].name + "' is " + number_text(thickness[m], 3) + " m thick, " +
             number_text(cells, 2) + " spacings; " +
             (unseen ? "the grid sees soil from " + number_text(asked) + " spacings on"
                     : "two grids, which an error estimate takes, need " + number_text(asked) +
                           ": the coarser one hardly sees it") +
             ": if it is weak, use a spacing of at most " + number_text(thickness[m] / asked, 2) + " m",
         issues);
  }
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
  } catch (const Error& error) {
    issues.push_back(error.issue());
  }
  return issues;
}

}  // namespace vbgpd
