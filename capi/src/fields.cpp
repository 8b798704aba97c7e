// Fields: what can be read, and copies of it into any strided layout.
#include <cstdlib>

#include "convert.h"
#include "guard.h"

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

const FieldInfo& field_in(std::int32_t field, int argument) {
  const auto all = fields();
  if (field >= 0 && static_cast<std::size_t>(field) < all.size()) return all[static_cast<std::size_t>(field)];
  throw ArgumentError(argument, Status::kArgument,
                      "There is no field " + std::to_string(field) + ": there are " + std::to_string(all.size()) +
                          ", numbered from 0.");
}

/// Where component c of item i goes: i*item + c*component bytes.
struct Strides {
  std::int64_t item, component;
};

// Every number must have bytes of its own: either rows lie apart and columns within them, or the other way round.
Strides strides_in(std::int64_t item, std::int64_t component, std::int64_t components, std::int64_t count,
                   int argument) {
  constexpr std::int64_t kNumber = 8;
  if (component == 0) component = kNumber;
  if (item == 0) item = kNumber * components;
  const std::int64_t step = components > 1 ? std::abs(component) : kNumber;
  const std::int64_t row = count > 1 ? std::abs(item) : kNumber * components;
  const bool apart = step >= kNumber && row >= kNumber &&
                     (components == 1 || count == 1 || (row - kNumber) / step >= components - 1 ||
                      (step - kNumber) / row >= count - 1);
  if (apart) return {item, component};
  throw ArgumentError(argument, Status::kArgument,
                      "The strides " + std::to_string(item) + " (item) and " + std::to_string(component) +
                          " (component) bytes make numbers of 8 bytes overlap.");
}

template <class Number>
void scatter(const std::vector<Number>& rows, int components, Strides strides, void* dst) {
  char* const at = static_cast<char*>(dst);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto item = static_cast<std::int64_t>(k) / components;
    const auto component = static_cast<std::int64_t>(k) % components;
    std::memcpy(at + item * strides.item + component * strides.component, &rows[k], sizeof(Number));
  }
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
    if (cap < 0) {
      throw ArgumentError(6, Status::kArgument,
                          "The capacity is " + std::to_string(cap) + " items; it must be 0 or more.");
    }
    const std::int64_t count = item_count(simulation, info.location);
    if (n != nullptr) *n = count;
    if (cap == 0) return Status::kOk;
    require_not_null(dst, 3, "dst");
    if (cap < count) {
      throw ArgumentError(
          6, Status::kBuffer,
          "The array holds " + std::to_string(cap) + " items; " + std::to_string(count) + " are needed.");
    }
    const Strides strides = strides_in(stride_item, stride_component, info.components, count, 4);
    scatter(rows_of<Number>(simulation, field, info.type), info.components, strides, dst);
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

vbgpd_status vbgpd_model_state_hash(const vbgpd_model* model, uint64_t* hash) {
  return with(model, [&](ModelObject& object) {
    require_not_null(hash, 2, "hash");
    *hash = object.engine->simulation->state_hash();
    return Status::kOk;
  });
}
