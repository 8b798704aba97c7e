#include "selection.h"

#include <numeric>

#include "arrays.h"
#include "geometry/polygon.h"

namespace vbgpd::capi {
namespace {

[[noreturn]] void refuse(int argument, const std::string& text) {
  throw ArgumentError(argument, Status::kArgument, text);
}

vbgpd_selection read_in(const vbgpd_selection* from, int argument) {
  require_struct(from, argument);
  vbgpd_selection to{};
  std::memcpy(&to, from, std::min<std::size_t>(from->struct_size, sizeof to));
  return to;
}

std::vector<std::int64_t> given_ids(const vbgpd_selection& s, std::int64_t particles, int argument) {
  if (s.n_ids < 0) refuse(argument, "n_ids is " + std::to_string(s.n_ids) + "; it must be 0 or more.");
  if (s.n_ids == 0) return {};
  require_not_null(s.ids, argument, "ids");
  const std::int64_t stride = s.ids_stride == 0 ? 8 : s.ids_stride;
  const auto ids = gather<std::int64_t>(s.ids, 1, {stride, 8}, s.n_ids);
  for (const std::int64_t id : ids) {
    if (id < 0 || id >= particles)
      refuse(argument, "There is no particle " + std::to_string(id) + ": there are " + std::to_string(particles) +
                           ", numbered from 0.");
  }
  return ids;
}

template <class Chosen>
std::vector<std::int64_t> those(std::int64_t particles, const Chosen& chosen) {
  std::vector<std::int64_t> ids;
  for (std::int64_t id = 0; id < particles; ++id) {
    if (chosen(static_cast<std::size_t>(id))) ids.push_back(id);
  }
  return ids;
}

void require_object(std::int64_t id, std::size_t count, const char* what, int argument) {
  if (id >= 0 && static_cast<std::uint64_t>(id) < count) return;
  refuse(argument, std::string("There is no ") + what + " " + std::to_string(id) + ": there are " +
                       std::to_string(count) + ", numbered from 0.");
}

/// Soil of the cells that a layer holds most of; soil particles are numbered in the order of their seeds.
std::vector<std::int64_t> of_layer(const Simulation& simulation, std::int64_t layer, int argument) {
  require_object(layer, simulation.scene().layers.size(), "layer", argument);
  std::vector<std::int64_t> ids;
  std::int64_t id = 0;
  for (const Seed& seed : simulation.section().seeds) {
    if (seed.hold != Hold::kFree) continue;
    if (simulation.runs_out() && !seed.active) continue;  // a run-out has no particle where there is no soil
    if (seed.layer == layer) ids.push_back(id);
    ++id;
  }
  return ids;
}

}  // namespace

const FieldInfo& field_in(std::int32_t field, int argument) {
  const auto all = fields();
  if (field >= 0 && static_cast<std::size_t>(field) < all.size()) return all[static_cast<std::size_t>(field)];
  refuse(argument, "There is no field " + std::to_string(field) + ": there are " + std::to_string(all.size()) +
                       ", numbered from 0.");
}

std::vector<double> field_rows(const Simulation& simulation, const char* field) {
  std::vector<double> rows;
  simulation.read(find_field(field), rows);
  return rows;
}

std::vector<std::int64_t> selected(const Simulation& simulation, const vbgpd_selection* selection, int argument) {
  const std::int64_t n = simulation.particle_count();
  const auto all = [](std::size_t) { return true; };
  if (selection == nullptr) return those(n, all);
  const vbgpd_selection s = read_in(selection, argument);
  const auto id = static_cast<double>(s.object_id);
  switch (s.kind) {
    case VBGPD_SELECT_ALL:
      return those(n, all);
    case VBGPD_SELECT_IDS:
      return given_ids(s, n, argument);
    case VBGPD_SELECT_BOX: {
      const auto xy = field_rows(simulation, "position");
      return those(n, [&](std::size_t k) {
        return xy[2 * k] >= s.xmin && xy[2 * k] <= s.xmax && xy[2 * k + 1] >= s.ymin && xy[2 * k + 1] <= s.ymax;
      });
    }
    case VBGPD_SELECT_POLYGON: {
      const std::int64_t stride = s.xy_stride == 0 ? 16 : s.xy_stride;
      const Polygon polygon = points_in(s.xy, stride, s.n_points, argument);
      if (polygon.size() < 3) refuse(argument, "The polygon of the selection needs 3 points or more.");
      const auto xy = field_rows(simulation, "position");
      return those(n, [&](std::size_t k) { return contains(polygon, Vec2(xy[2 * k], xy[2 * k + 1])); });
    }
    case VBGPD_SELECT_MATERIAL: {
      require_object(s.object_id, simulation.scene().materials.size(), "material", argument);
      const auto material = field_rows(simulation, "material"), boundary = field_rows(simulation, "boundary");
      return those(n, [&](std::size_t k) { return material[k] == id && boundary[k] < 0; });
    }
    case VBGPD_SELECT_LAYER:
      return of_layer(simulation, s.object_id, argument);
    case VBGPD_SELECT_BOUNDARY: {
      require_object(s.object_id, simulation.section().boundaries.size(), "boundary", argument);
      const auto boundary = field_rows(simulation, "boundary");
      return those(n, [&](std::size_t k) { return boundary[k] == id; });
    }
    case VBGPD_SELECT_SOIL: {
      const auto boundary = field_rows(simulation, "boundary");
      return those(n, [&](std::size_t k) { return boundary[k] < 0; });
    }
    default:
      refuse(argument,
             "The kind of selection is " + std::to_string(s.kind) + "; it must be one of VBGPD_SELECT_* (0 to 7).");
  }
}

}  // namespace vbgpd::capi
