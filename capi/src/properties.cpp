// The named numbers of every kind of object, each describing itself, from the tables of the engine.
#include "scene/properties.h"

#include "convert.h"
#include "guard.h"

namespace vbgpd::capi {
namespace {

vbgpd_property_info info_of(const char* name, const char* unit, const char* doc, double default_value, double min_value,
                            double max_value) {
  vbgpd_property_info info{};
  info.struct_size = sizeof info;
  info.name = name;
  info.unit = unit;
  info.doc = doc;
  info.default_value = default_value;
  info.min_value = min_value;
  info.max_value = max_value;
  return info;
}

vbgpd_property_info info_of(const Property& from) {
  auto info = info_of(from.name, from.unit, from.doc, from.default_value, from.min_value, from.max_value);
  info.required = from.required ? 1 : 0;
  info.min_open = from.min_open ? 1 : 0;
  info.max_open = from.max_open ? 1 : 0;
  return info;
}

vbgpd_property_info info_of(const NamedValue& from) {
  auto info = info_of(from.name, from.unit, from.doc, from.default_value, from.min_value, from.max_value);
  info.min_open = from.min_open ? 1 : 0;
  info.max_open = from.max_open ? 1 : 0;
  return info;
}

std::vector<vbgpd_property_info> table_of(std::int32_t object_kind) {
  if (object_kind < VBGPD_OBJECT_CONTEXT || object_kind > VBGPD_OBJECT_JOB) {
    throw ArgumentError(1, Status::kArgument, "object_kind must be one of VBGPD_OBJECT_*.");
  }
  std::vector<vbgpd_property_info> table;
  for (const Property& property : properties()) {
    if (static_cast<std::int32_t>(property.object) == object_kind) table.push_back(info_of(property));
  }
  if (object_kind == VBGPD_OBJECT_MODEL) {
    for (const NamedValue& value : named_values()) {
      if (value.settable) table.push_back(info_of(value));
    }
  }
  if (object_kind == VBGPD_OBJECT_JOB) {
    for (const JobOption& option : job_options()) {
      table.push_back(
          info_of(option.name, option.unit, option.doc, option.default_value, option.min_value, option.max_value));
    }
  }
  return table;
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_property_count(int32_t object_kind, int64_t* n) {
  return guarded([&] {
    require_not_null(n, 2, "n");
    *n = static_cast<std::int64_t>(table_of(object_kind).size());
    return Status::kOk;
  });
}

vbgpd_status vbgpd_property_info_at(int32_t object_kind, int64_t i, vbgpd_property_info* info) {
  return guarded([&] {
    require_struct(info, 3);
    const auto table = table_of(object_kind);
    const vbgpd_property_info* const property = item_at(table, i, 2);
    if (property == nullptr) return Status::kEndOfData;
    fill(info, *property);
    return Status::kOk;
  });
}
