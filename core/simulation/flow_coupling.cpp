// Setting a run-out from outside while it runs, and lending its arrays.
#include <cmath>

#include "simulation/build_flow.h"
#include "simulation/flow_simulation.h"
#include "simulation/surface_load.h"
#include "state/flow_neighbours.h"

namespace vbgpd {

void FlowSimulation::write(int field, const std::vector<double>& rows) {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  const std::string_view name = info.name;
  if (!info.writable) throw Error(Status::kState, std::string("field '") + info.name + "' can be read, not written");
  if (rows.size() != static_cast<std::size_t>(info.components) * static_cast<std::size_t>(model_.particles))
    throw Error(Status::kArgument, std::string("field '") + info.name + "' needs a row for every particle");
  require_writable(info, rows);
  if (name == "velocity") return write_velocity(rows);
  Outside changed = outside();
  if (name == "pore_pressure") changed.pore_pressure = pressure_of(rows, model_.heap);
  else push_by(rows, model_.heap, changed);
  take_forces(drive_, std::move(changed));
}

void FlowSimulation::write_velocity(const std::vector<double>& rows) {
  const Real before = kinetic_energy();
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i) {
    const auto id = static_cast<std::size_t>(state_.particle[i]);
    state_.motion[4 * i + 2] = rows[2 * id], state_.motion[4 * i + 3] = rows[2 * id + 1];
  }
  if (ledger_.open) ledger_.external += kinetic_energy() - before;
  farther_at_ = time_;
}

void FlowSimulation::set_drive(const Drive& drive) {
  require_drive(drive, drive_, section_);
  take_forces(drive, outside());
}

Outside FlowSimulation::outside() const {
  Outside all = outside_;
  all.pore_pressure = model_.pore_pressure;
  return all;
}

void FlowSimulation::take_forces(Drive drive, Outside outside) {
  const auto n = static_cast<std::size_t>(model_.particles);
  Array x, y;
  x.allocate(n, 0, model_.heap), y.allocate(n, 0, model_.heap);
  for (std::size_t id = 0; id < n; ++id)
    x[id] = drive.kh * model_.weight[id], y[id] = -(1 + drive.kv) * model_.weight[id];
  if (model_.surface_area.present()) {
    std::vector<std::size_t> id_of(section_.seeds.size());  // soil is numbered in the order of the seeds
    std::size_t next = 0;
    for (std::size_t k = 0; k < id_of.size(); ++k)
      if (section_.seeds[k].hold == Hold::kFree && section_.seeds[k].active) id_of[k] = next++;
    spread_surface_loads(
        drive.loads, section_, scene_.smoothing_ratio,
        [&](std::size_t seed) { return model_.surface_area[id_of[seed]]; },
        [&](std::size_t seed, Real force) { y[id_of[seed]] += force; });
  }
  const auto add = [](const Array& from, Array& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] += from[i];
  };
  add(outside.external_x, x), add(outside.external_y, y);
  Real scale = 0;
  for (std::size_t id = 0; id < n; ++id) scale += std::fabs(x[id]) + std::fabs(y[id]);
  Array placed;  // made first: when memory runs out nothing has changed
  if (lists_.force.present()) placed.allocate(outside.pore_pressure.size(), 5, model_.heap);
  model_.force_x = std::move(x), model_.force_y = std::move(y), model_.force_scale = scale;
  model_.pore_pressure = std::move(outside.pore_pressure);
  outside.pore_pressure = Array{};
  drive_ = std::move(drive), outside_ = std::move(outside);
  farther_at_ = time_;
  if (!lists_.force.present()) return;
  lists_.pore_pressure = std::move(placed);
  place_forces(model_, state_, lists_);
}

FieldView FlowSimulation::view(int field) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  const std::string_view name = info.name;
  FieldView out;
  out.count = model_.particles, out.stride_component = sizeof(double);
  const auto lend = [&](const double* data, std::int64_t doubles) {
    out.data = data, out.stride_item = doubles * static_cast<std::int64_t>(sizeof(double));
  };
  if (name == "velocity") {
    lend(state_.motion.data() + 2, 4);
  } else if (name == "volume") {
    lend(lists_.constants.data(), 4);
  } else if (name == "mass") {
    lend(lists_.constants.data() + 1, 4);
  } else if (name == "plastic_strain") {
    lend(state_.plastic_strain.data(), 1);
  } else if (name == "particle_id") {
    if (storage_ids_.empty()) {
      std::vector<std::int64_t> ids(state_.particle.size());
      for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int64_t>(state_.particle[i]);
      storage_ids_ = std::move(ids);
    }
    out.data = storage_ids_.data(), out.stride_item = sizeof(std::int64_t);
  } else {
    throw Error(Status::kUnsupported, std::string("field '") + info.name +
                                          "' is not stored as such in a run-out: read a copy; velocity, mass, volume, "
                                          "plastic_strain and particle_id can be viewed");
  }
  return out;
}

}  // namespace vbgpd
