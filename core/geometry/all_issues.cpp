#include <algorithm>
#include <iterator>

#include "geometry/check.h"
#include "scene/validate.h"

namespace vbgpd {

namespace {

/// The same fault seen twice: once as a value, once as a shape.
bool same_place(const Issue& a, const Issue& b) {
  return a.severity == Severity::kError && a.object == b.object && a.object_id == b.object_id && a.item == b.item;
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
  return issues;
}

}  // namespace vbgpd
