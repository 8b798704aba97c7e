// The named numbers of a scene, each describing itself. One table serves range checks, set/get by name and
// documentation.
#pragma once

#include <span>
#include <string_view>

#include "scene/scene_def.h"

namespace vbgpd {

struct Property {
  ObjectKind object;                           ///< kMaterial, kLoad, kBoundary, or kProfile for the scene itself
  const char* name;                            ///< "cohesion"
  const char* unit;                            ///< UDUNITS: "Pa", "N m-3", "degree", "1"
  const char* doc;                             ///< one sentence
  double default_value, min_value, max_value;  ///< NaN default = none; the range includes its ends unless *_open
  bool min_open, max_open;
  bool required;
};

/// All properties, those of one kind together.
std::span<const Property> properties();
/// The number named `name` of object `id` of a kind, or nullptr when there is none of that name or no such object.
/// For ObjectKind::kProfile id is ignored; its names include srf_min, srf_max, srf_tolerance, kh, kv, gravity, spacing,
/// smoothing_ratio.
double* find_property(SceneDef& scene, ObjectKind object, std::int64_t id, std::string_view name);
const double* find_property(const SceneDef& scene, ObjectKind object, std::int64_t id, std::string_view name);

}  // namespace vbgpd
