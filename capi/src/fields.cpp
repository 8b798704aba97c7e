// Fields: what can be read, and copies of it into any strided layout.
#include "arrays.h"
#include "guard.h"
#include "selection.h"

namespace vbgpd::capi {
namespace {

Location location_in(std::int32_t location, int argument) {
  if (location == VBGPD_AT_PARTICLE) return Location::kParticle;
  if (location == VBGPD_AT_BOND) return Location::kBond;
  throw ArgumentError(
      argument, Status::kArgument,
      "The location is " + std::to_string(location) + "; it must be VBGPD_AT_PARTICLE (1) or VBGPD_AT_BOND (2).");
}

std::int64_t item_count(const Simulation& simulation, Location location) {
  return location == Location::kBond ? simulation.bond_count() : simulation.particle_count();
}

template <class Number>
std::vector<Number> rows_of(const Simulation& simulation, int field, FieldType type) {
  std::vector<Number> rows;
  if constexpr (std::is_same_v<Number, double>) {
    if (type == FieldType::kInteger) {
      std::vector<std::int64_t> whole;
      simulation.read(field, whole);
      rows.assign(whole.begin(), whole.end());
      return rows;
    }
  } else if (type != FieldType::kInteger) {
    throw ArgumentError(2, Status::kArgument, "This field holds real numbers; read it with vbgpd_model_read_f64.");
  }
  simulation.read(field, rows);
  return rows;
}

template <class Number>
vbgpd_status read_field(const vbgpd_model* model, std::int32_t field, Number* dst, std::int64_t stride_item,
                        std::int64_t stride_component, std::int64_t cap, std::int64_t* n) noexcept {
  return with(model, [&](ModelObject& object) {
    const Simulation& simulation = *object.engine->simulation;
    const FieldInfo& info = field_in(field, 2);
    const std::int64_t count = item_count(simulation, info.location);
    if (!items_fit(count, cap, n, 6)) return Status::kOk;
    require_not_null(dst, 3, "dst");
    const Strides strides = strides_in(stride_item, stride_component, info.components, count, 4);
    scatter(rows_of<Number>(simulation, field, info.type), info.components, strides, dst);
    return Status::kOk;
  });
}

template <class Number>
vbgpd_status read_selected(const vbgpd_model* model, std::int32_t field, const vbgpd_selection* selection, Number* dst,
                           std::int64_t stride_item, std::int64_t stride_component, std::int64_t cap,
                           std::int64_t* n) noexcept {
  return with(model, [&](ModelObject& object) {
    const Simulation& simulation = *object.engine->simulation;
    const FieldInfo& info = field_in(field, 2);
    if (info.location != Location::kParticle)
      throw ArgumentError(2, Status::kArgument, "Selections are of particles; this is a field of bonds.");
    const std::vector<std::int64_t> ids = selected(simulation, selection, 3);
    const auto count = static_cast<std::int64_t>(ids.size());
    if (!items_fit(count, cap, n, 7) || count == 0) return Status::kOk;
    require_not_null(dst, 4, "dst");
    const Strides strides = strides_in(stride_item, stride_component, info.components, count, 5);
    const std::vector<Number> all = rows_of<Number>(simulation, field, info.type);
    std::vector<Number> rows;
    rows.reserve(ids.size() * static_cast<std::size_t>(info.components));
    for (const std::int64_t id : ids) {
      const auto first = all.begin() + id * info.components;
      rows.insert(rows.end(), first, first + info.components);
    }
    scatter(rows, info.components, strides, dst);
    return Status::kOk;
  });
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_field_count(int64_t* n) {
  return guarded([&] {
    require_not_null(n, 1, "n");
    *n = static_cast<std::int64_t>(fields().size());
    return Status::kOk;
  });
}

vbgpd_status vbgpd_field_info_at(int64_t i, vbgpd_field_info* info) {
  return guarded([&] {
    require_struct(info, 2);
    const FieldInfo* const field = item_at(fields(), i, 1);
    if (field == nullptr) return Status::kEndOfData;
    vbgpd_field_info told{};
    told.struct_size = sizeof told;
    told.type = static_cast<std::int32_t>(field->type);
    told.location = static_cast<std::int32_t>(field->location);
    told.components = field->components;
    told.name = field->name;
    told.unit = field->unit;
    told.doc = field->doc;
    told.writable = field->writable ? 1 : 0;
    fill(info, told);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_field_find(const char* name, int64_t len, int32_t* field) {
  return guarded([&] {
    require_not_null(field, 3, "field");
    const int found = find_field(text_in(name, len, 1, "name"));
    if (found < 0) throw ArgumentError(1, Status::kUnknownName, "There is no field of that name.");
    *field = found;
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_item_count(const vbgpd_model* model, int32_t location, int64_t* n) {
  return with(model, [&](ModelObject& object) {
    require_not_null(n, 3, "n");
    *n = item_count(*object.engine->simulation, location_in(location, 2));
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_read_f64(const vbgpd_model* model, int32_t field, double* dst, int64_t stride_item,
                                  int64_t stride_component, int64_t cap, int64_t* n) {
  return read_field(model, field, dst, stride_item, stride_component, cap, n);
}

vbgpd_status vbgpd_model_read_i64(const vbgpd_model* model, int32_t field, int64_t* dst, int64_t stride_item,
                                  int64_t stride_component, int64_t cap, int64_t* n) {
  return read_field(model, field, dst, stride_item, stride_component, cap, n);
}

vbgpd_status vbgpd_model_select(const vbgpd_model* model, const vbgpd_selection* selection, int64_t* ids,
                                int64_t stride, int64_t cap, int64_t* n) {
  return with(model, [&](ModelObject& object) {
    const std::vector<std::int64_t> found = selected(*object.engine->simulation, selection, 2);
    const auto count = static_cast<std::int64_t>(found.size());
    if (!items_fit(count, cap, n, 5) || count == 0) return Status::kOk;
    require_not_null(ids, 3, "ids");
    scatter(found, 1, {stride_in(stride, count, 4), 8}, ids);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_read_selected_f64(const vbgpd_model* model, int32_t field, const vbgpd_selection* selection,
                                           double* dst, int64_t stride_item, int64_t stride_component, int64_t cap,
                                           int64_t* n) {
  return read_selected(model, field, selection, dst, stride_item, stride_component, cap, n);
}

vbgpd_status vbgpd_model_read_selected_i64(const vbgpd_model* model, int32_t field, const vbgpd_selection* selection,
                                           int64_t* dst, int64_t stride_item, int64_t stride_component, int64_t cap,
                                           int64_t* n) {
  return read_selected(model, field, selection, dst, stride_item, stride_component, cap, n);
}

vbgpd_status vbgpd_model_state_hash(const vbgpd_model* model, uint64_t* hash) {
  return with(model, [&](ModelObject& object) {
    require_not_null(hash, 2, "hash");
    *hash = object.engine->simulation->state_hash();
    return Status::kOk;
  });
}
