// Profiles: creation and the parts a profile is made of. Values are checked as a whole, by profile_check.cpp.
#include <cmath>

#include "arrays.h"
#include "exchange/scene_buffer.h"
#include "guard.h"
#include "scene_access.h"

namespace vbgpd::capi {
namespace {

// Appends and gives the new id; nothing has changed when the memory does not suffice.
template <class Part>
void append(std::vector<Part>& parts, Part part, std::int64_t* id) {
  parts.push_back(std::move(part));
  if (id != nullptr) *id = static_cast<std::int64_t>(parts.size()) - 1;
}

BoundaryKind boundary_kind(std::int32_t kind, int argument) {
  switch (kind) {
    case VBGPD_BOUNDARY_FREE:
      return BoundaryKind::kFree;
    case VBGPD_BOUNDARY_FIXED:
      return BoundaryKind::kFixed;
    case VBGPD_BOUNDARY_ROLLER:
      return BoundaryKind::kRoller;
    case VBGPD_BOUNDARY_VELOCITY:
      return BoundaryKind::kVelocity;
    default:
      throw ArgumentError(argument, Status::kArgument,
                          "The kind of boundary is " + std::to_string(kind) +
                              "; it must be VBGPD_BOUNDARY_FREE, FIXED, ROLLER or VELOCITY (0 to 3).");
  }
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_profile_create(vbgpd_context* context, vbgpd_profile** out) {
  return with(context, [&](ContextObject&) {
    require_not_null(out, 2, "out");
    hand_out(std::make_unique<ProfileObject>(), out);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_create_from_flatbuffer(vbgpd_context* context, const void* bytes, int64_t len,
                                                  vbgpd_profile** out) {
  return with(context, [&](ContextObject&) {
    require_not_null(out, 4, "out");
    auto profile = std::make_unique<ProfileObject>();
    profile->scene = scene_from_flatbuffer(bytes_in(bytes, len, 2));
    hand_out(std::move(profile), out);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_to_flatbuffer(const vbgpd_profile* profile, void* buf, int64_t cap, int64_t* needed) {
  return with(profile, [&](ProfileObject& object) {
    bytes_out(scene_to_flatbuffer(object.scene), buf, cap, needed, 2);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_destroy(vbgpd_profile* profile) { return destroy(profile); }

vbgpd_status vbgpd_profile_set_exterior(vbgpd_profile* profile, const double* xy, int64_t stride, int64_t n) {
  return with(profile, [&](ProfileObject& object) {
    object.scene.exterior = points_in(xy, stride, n, 2);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_add_material(vbgpd_profile* profile, const char* name, int64_t len, int64_t* material_id) {
  return with(profile, [&](ProfileObject& object) {
    MaterialDef material;
    material.name = text_in(name, len, 2, "name");
    require_new_material_name(object.scene, material.name, 2);
    append(object.scene.materials, std::move(material), material_id);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_add_layer(vbgpd_profile* profile, const double* xy, int64_t stride, int64_t n,
                                     int64_t material_id, int64_t* layer_id) {
  return with(profile, [&](ProfileObject& object) {
    require_part(object.scene, ObjectKind::kMaterial, material_id, 5);
    LayerDef layer;
    layer.material = object.scene.materials[static_cast<std::size_t>(material_id)].name;
    layer.polygon = points_in(xy, stride, n, 2);
    append(object.scene.layers, std::move(layer), layer_id);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_add_boundary(vbgpd_profile* profile, const char* side, int64_t side_len, const double* xy,
                                        int64_t stride, int64_t n, int32_t kind, int64_t* boundary_id) {
  return with(profile, [&](ProfileObject& object) {
    BoundaryDef boundary;
    if (side != nullptr) boundary.side = text_in(side, side_len, 2, "side");
    boundary.polyline = points_in(xy, stride, n, 4);
    if (boundary.side.empty() == boundary.polyline.empty()) {
      throw ArgumentError(boundary.side.empty() ? 2 : 6, Status::kArgument,
                          "A boundary is given either by a side (\"base\", \"left\", \"right\") or by a polyline, "
                          "not by both and not by neither.");
    }
    boundary.kind = boundary_kind(kind, 7);
    append(object.scene.boundaries, std::move(boundary), boundary_id);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_add_load(vbgpd_profile* profile, double x0, double x1, double pressure, double pressure_end,
                                    int64_t* load_id) {
  return with(profile, [&](ProfileObject& object) {
    append(object.scene.loads, LoadDef{x0, x1, pressure, pressure_end}, load_id);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_set_water_table(vbgpd_profile* profile, const double* xy, int64_t stride, int64_t n) {
  return with(profile, [&](ProfileObject& object) {
    object.scene.water_table = points_in(xy, stride, n, 2);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_water_table(const vbgpd_profile* profile, double* xy, int64_t stride, int64_t cap,
                                       int64_t* n) {
  return with(profile, [&](ProfileObject& object) {
    points_out(object.scene.water_table, xy, stride, cap, n, 2);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_set_f64(vbgpd_profile* profile, int32_t object_kind, int64_t id, const char* name,
                                   int64_t len, double value) {
  return with(profile, [&](ProfileObject& object) {
    const ObjectKind kind = part_kind(object_kind, 2);
    require_part(object.scene, kind, id, 3);
    const std::string_view key = text_in(name, len, 4, "name");
    double& number = named_number(object.scene, kind, id, key, 4);
    number = std::isnan(value) ? default_number(kind, key) : value;
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_get_f64(const vbgpd_profile* profile, int32_t object_kind, int64_t id, const char* name,
                                   int64_t len, double* value) {
  return with(profile, [&](ProfileObject& object) {
    require_not_null(value, 6, "value");
    const ObjectKind kind = part_kind(object_kind, 2);
    require_part(object.scene, kind, id, 3);
    *value = named_number(object.scene, kind, id, text_in(name, len, 4, "name"), 4);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_set_text(vbgpd_profile* profile, int32_t object_kind, int64_t id, const char* name,
                                    int64_t len, const char* value, int64_t value_len) {
  return with(profile, [&](ProfileObject& object) {
    const ObjectKind kind = part_kind(object_kind, 2);
    require_part(object.scene, kind, id, 3);
    const std::string_view key = text_in(name, len, 4, "name");
    set_named_text(object.scene, kind, id, key, 4, text_in(value, value_len, 6, "value"), 6);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_get_text(const vbgpd_profile* profile, int32_t object_kind, int64_t id, const char* name,
                                    int64_t len, char* buf, int64_t cap, int64_t* needed) {
  return with(profile, [&](ProfileObject& object) {
    const ObjectKind kind = part_kind(object_kind, 2);
    require_part(object.scene, kind, id, 3);
    text_out(named_text(object.scene, kind, id, text_in(name, len, 4, "name"), 4), buf, cap, needed, 6);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_count(const vbgpd_profile* profile, int32_t object_kind, int64_t* n) {
  return with(profile, [&](ProfileObject& object) {
    require_not_null(n, 3, "n");
    *n = part_count(object.scene, part_kind(object_kind, 2));
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_polygon(const vbgpd_profile* profile, int32_t object_kind, int64_t id, double* xy,
                                   int64_t stride, int64_t cap, int64_t* n) {
  return with(profile, [&](ProfileObject& object) {
    points_out(polygon_of(object.scene, part_kind(object_kind, 2), id, 3), xy, stride, cap, n, 4);
    return Status::kOk;
  });
}
