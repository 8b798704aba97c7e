// Finds the parts of a scene by kind, id and name, with errors that say what there is instead.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene_def.h"

namespace vbgpd::capi {

/// "material", "layer" ...
const char* kind_name(ObjectKind kind);
/// VBGPD_OBJECT_* of an argument; only the parts of a profile pass.
ObjectKind part_kind(std::int32_t object_kind, int argument);
std::int64_t part_count(const SceneDef& scene, ObjectKind kind);
/// Throws unless the object exists; ids of the profile itself are ignored.
void require_part(const SceneDef& scene, ObjectKind kind, std::int64_t id, int argument);

/// A named number or text of an existing part; throws Error(kUnknownName) listing the names there are.
double& named_number(SceneDef& scene, ObjectKind kind, std::int64_t id, std::string_view name, int argument);
std::string named_text(SceneDef& scene, ObjectKind kind, std::int64_t id, std::string_view name, int argument);
/// Throws Error also where the text may not be that: a name another material has, an unknown kind of boundary.
void set_named_text(SceneDef& scene, ObjectKind kind, std::int64_t id, std::string_view name, int argument,
                    std::string_view value, int value_argument);
/// What the number is when the user says nothing; NaN = no default.
double default_number(ObjectKind kind, std::string_view name);

/// Exterior, layer polygon or boundary polyline.
const Polygon& polygon_of(const SceneDef& scene, ObjectKind kind, std::int64_t id, int id_argument);

/// Refuses an empty name and one another material has: layers find their material by name.
void require_new_material_name(const SceneDef& scene, std::string_view name, int argument);

}  // namespace vbgpd::capi
