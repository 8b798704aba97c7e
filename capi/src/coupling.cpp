// Setting a model from outside while it runs: fields, loads, moved boundaries; what its boundaries feel.
#include <cmath>

#include "arrays.h"
#include "guard.h"
#include "scene/wording.h"
#include "selection.h"
#include "simulation/outside.h"
#include "simulation/scattered.h"

namespace vbgpd::capi {
namespace {

const FieldInfo& writable_field(std::int32_t field) {
  const FieldInfo& info = field_in(field, 2);
  if (info.writable) return info;
  throw ArgumentError(2, Status::kState, std::string("The field ") + info.name + " can be read, not written.");
}

void require_id(std::int64_t id, std::size_t count, const char* what) {
  if (id >= 0 && static_cast<std::uint64_t>(id) < count) return;
  throw ArgumentError(2, Status::kArgument,
                      std::string("There is no ") + what + " " + std::to_string(id) + ": there are " +
                          std::to_string(count) + ", numbered from 0.");
}

/// The field as it is, for a call that replaces some of it.
std::vector<double> present_rows(const Simulation& simulation, std::int32_t field) {
  std::vector<double> rows;
  simulation.read(field, rows);
  return rows;
}

/// Beyond it squares of distances between places and particles would overflow; no map reaches as far.
constexpr double kFarthest = 1e12;
bool on_a_map(double coordinate) { return std::fabs(coordinate) <= kFarthest; }
std::string map_range() {
  return "coordinates must be between -" + number_text(kFarthest) + " and " + number_text(kFarthest) + " m.";
}

void require_places(const std::vector<Point>& places) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (on_a_map(places[k].x) && on_a_map(places[k].y)) continue;
    const bool finite = std::isfinite(places[k].x) && std::isfinite(places[k].y);
    Issue issue;
    issue.status = Status::kRange, issue.item = static_cast<std::int64_t>(k);
    issue.text = "Place " + std::to_string(k) +
                 (finite ? " is at (" + number_text(places[k].x) + ", " + number_text(places[k].y) + "); " + map_range()
                         : " has a coordinate that is not a finite number.");
    throw ArgumentError(3, issue);
  }
}

/// The issue's item is the place, as the caller numbers them, not a particle that would get a value from there.
void require_values(const FieldInfo& info, const std::vector<double>& given, bool gaps, int argument) {
  const double largest = largest_written(info);
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (std::fabs(given[k]) <= largest || (gaps && std::isnan(given[k]))) continue;
    Issue issue;
    issue.status = Status::kRange, issue.item = static_cast<std::int64_t>(k) / info.components, issue.value = given[k];
    issue.text = "The value at place " + std::to_string(issue.item) + " " + fault_text(given[k], largest) + ".";
    throw ArgumentError(argument, issue);
  }
}

void require_raster(double x0, double y0, double dx, double dy, std::int64_t nx, std::int64_t ny) {
  if (!(std::isfinite(x0) && std::isfinite(y0) && std::isfinite(dx) && std::isfinite(dy) && dx > 0 && dy > 0))
    throw ArgumentError(5, Status::kArgument, "A raster needs a finite corner and steps dx, dy above 0.");
  if (nx < 1 || ny < 1 || nx > (std::int64_t{1} << 31) / ny)
    throw ArgumentError(7, Status::kArgument, "A raster has 1 or more columns and rows, at most 2^31 places.");
  if (!(on_a_map(x0) && on_a_map(y0) && on_a_map(x0 + static_cast<double>(nx - 1) * dx) &&
        on_a_map(y0 + static_cast<double>(ny - 1) * dy)))
    throw ArgumentError(3, Status::kRange,
                        "The raster reaches beyond " + number_text(kFarthest) + " m; " + map_range());
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_write_f64(vbgpd_model* model, int32_t field, const vbgpd_selection* selection,
                                   const double* src, int64_t stride_item, int64_t stride_component, int64_t n) {
  return with(model, [&](ModelObject& object) {
    Simulation& simulation = object.engine->to_change();
    const FieldInfo& info = writable_field(field);
    const std::vector<std::int64_t> ids = selected(simulation, selection, 3);
    if (n != static_cast<std::int64_t>(ids.size()))
      throw ArgumentError(
          7, Status::kArgument,
          "n is " + std::to_string(n) + "; the selection has " + std::to_string(ids.size()) + " particles.");
    if (n == 0) return Status::kOk;
    require_not_null(src, 4, "src");
    const Strides strides = strides_in(stride_item, stride_component, info.components, n, 5);
    const std::vector<double> given = gather<double>(src, info.components, strides, n);
    std::vector<double> rows = present_rows(simulation, field);
    for (std::size_t k = 0; k < ids.size(); ++k)
      std::copy_n(given.begin() + static_cast<std::ptrdiff_t>(k) * info.components, info.components,
                  rows.begin() + ids[k] * info.components);
    simulation.write(field, rows);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_write_points(vbgpd_model* model, int32_t field, const double* xy, int64_t stride_xy,
                                      const double* src, int64_t stride_item, int64_t stride_component, int64_t n) {
  return with(model, [&](ModelObject& object) {
    Simulation& simulation = object.engine->to_change();
    const FieldInfo& info = writable_field(field);
    if (n < 1) throw ArgumentError(8, Status::kArgument, "n must be 1 or more.");
    std::vector<Point> places = points_in(xy, stride_xy, n, 3);
    require_places(places);
    require_not_null(src, 5, "src");
    const Strides strides = strides_in(stride_item, stride_component, info.components, n, 6);
    std::vector<double> given = gather<double>(src, info.components, strides, n);
    require_values(info, given, false, 5);
    const Scattered values(std::move(places), std::move(given), info.components);
    const std::vector<double> at = field_rows(simulation, "position");
    const auto components = static_cast<std::size_t>(info.components);
    std::vector<double> rows(at.size() / 2 * components);
    for (std::size_t k = 0; k < at.size() / 2; ++k) values.at(at[2 * k], at[2 * k + 1], &rows[k * components]);
    simulation.write(field, rows);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_write_grid(vbgpd_model* model, int32_t field, double x0, double y0, double dx, double dy,
                                    int64_t nx, int64_t ny, const double* src, int64_t stride_item) {
  return with(model, [&](ModelObject& object) {
    Simulation& simulation = object.engine->to_change();
    const FieldInfo& info = writable_field(field);
    if (info.components != 1)
      throw ArgumentError(2, Status::kArgument, "A raster has one value per place; this field has more components.");
    require_raster(x0, y0, dx, dy, nx, ny);
    require_not_null(src, 9, "src");
    const std::int64_t stride = stride_in(stride_item, nx * ny, 10);
    const Raster raster{x0, y0, dx, dy, nx, ny, gather<double>(src, 1, {stride, 8}, nx * ny)};
    require_values(info, raster.values, true, 9);
    const std::vector<double> at = field_rows(simulation, "position");
    std::vector<double> rows = present_rows(simulation, field);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double value = raster.at(at[2 * k], at[2 * k + 1]);
      if (!std::isnan(value)) rows[k] = value;
    }
    simulation.write(field, rows);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_set_load(vbgpd_model* model, int64_t load_id, double pressure, double pressure_end) {
  return with(model, [&](ModelObject& object) {
    Simulation& simulation = object.engine->to_change();
    Drive drive = simulation.drive();
    require_id(load_id, drive.loads.size(), "load");
    LoadDef& load = drive.loads[static_cast<std::size_t>(load_id)];
    load.pressure = pressure, load.pressure_end = pressure_end;
    simulation.set_drive(drive);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_set_boundary_velocity(vbgpd_model* model, int64_t boundary_id, double vx, double vy) {
  return with(model, [&](ModelObject& object) {
    Simulation& simulation = object.engine->to_change();
    Drive drive = simulation.drive();
    require_id(boundary_id, drive.velocities.size(), "boundary");
    drive.velocities[static_cast<std::size_t>(boundary_id)] = Vec2(vx, vy);
    simulation.set_drive(drive);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_set_layer_active(vbgpd_model* model, int64_t layer_id, int32_t active) {
  return with(model, [&](ModelObject& object) {
    Simulation& simulation = object.engine->to_change();
    require_id(layer_id, simulation.scene().layers.size(), "layer");
    if (active != 0 && active != 1)
      throw ArgumentError(3, Status::kArgument,
                          "active is " + std::to_string(active) + "; it must be 1 (the soil is there) or 0.");
    Layers layers = simulation.layers();
    if (layers.empty()) layers.assign(simulation.scene().layers.size(), true);
    layers[static_cast<std::size_t>(layer_id)] = active == 1;
    try {
      simulation.set_layers(layers);
    } catch (const Error& error) {
      Issue issue = error.issue();
      if (issue.status == Status::kArgument) issue.object = ObjectKind::kLayer, issue.object_id = layer_id;
      throw ArgumentError(2, issue);
    }
    object.engine->events.forget(simulation);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_boundary_reaction(const vbgpd_model* model, int64_t boundary_id, double* fx, double* fy) {
  return with(model, [&](ModelObject& object) {
    const Simulation& simulation = *object.engine->simulation;
    require_not_null(fx, 3, "fx");
    require_not_null(fy, 4, "fy");
    require_id(boundary_id, simulation.section().boundaries.size(), "boundary");
    const Vec2 force = simulation.boundary_reaction(static_cast<std::size_t>(boundary_id));
    *fx = force.x(), *fy = force.y();
    return Status::kOk;
  });
}
