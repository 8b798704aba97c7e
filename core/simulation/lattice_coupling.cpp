// Setting a lattice simulation from outside while it runs, and lending its arrays.
#include <cmath>

#include "simulation/build_model.h"
#include "simulation/ground_water.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {

namespace {

/// Item i of component c, by particle id, into storage order; absent when all are zero.
Array by_storage(const Model& m, const std::vector<double>& rows, std::size_t components, std::size_t c, int stagger) {
  Array out;
  bool any = false;
  for (std::size_t k = c; k < rows.size(); k += components) any |= rows[k] != 0;
  if (!any) return out;
  out.allocate(static_cast<std::size_t>(m.storage), stagger, m.heap);
  for (std::size_t k = 0; k < m.id_of.size(); ++k)
    out[static_cast<std::size_t>(m.storage_of[k])] = rows[static_cast<std::size_t>(m.id_of[k]) * components + c];
  return out;
}

}  // namespace

Array LatticeSimulation::stored_pressure(const std::vector<double>& rows) const {
  return by_storage(model_, rows, 1, 0, 2);
}

void LatticeSimulation::write(int field, const std::vector<double>& rows) {
  audit_.valid = false;
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  const std::string_view name = info.name;
  const auto components = static_cast<std::size_t>(info.components);
  if (!info.writable) throw Error(Status::kState, std::string("field '") + info.name + "' can be read, not written");
  if (rows.size() != section_.seeds.size() * components)
    throw Error(Status::kArgument, std::string("field '") + info.name + "' needs a row for every particle");
  require_writable(info, rows);
  if (name == "velocity") return write_velocity(rows);
  Outside changed = outside_;
  if (name == "pore_pressure") {
    changed.pore_pressure = stored_pressure(rows);
  } else {
    changed.external_x = by_storage(model_, rows, 2, 0, 3);
    changed.external_y = by_storage(model_, rows, 2, 1, 4);
  }
  take_forces(drive_, std::move(changed));
}

void LatticeSimulation::write_velocity(const std::vector<double>& rows) {
  const auto energy = [&] {
    Real sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model_.storage); ++i)
      sum +=
          model_.mass[i] * (state_.velocity_x[i] * state_.velocity_x[i] + state_.velocity_y[i] * state_.velocity_y[i]);
    return sum / 2;
  };
  const Real before = energy();
  for (std::size_t k = 0; k < model_.id_of.size(); ++k) {
    const auto i = static_cast<std::size_t>(model_.storage_of[k]);
    const double* row = rows.data() + 2 * static_cast<std::size_t>(model_.id_of[k]);
    state_.velocity_x[i] = row[0] * model_.free_x[i], state_.velocity_y[i] = row[1] * model_.free_y[i];
  }
  since_restart_ = 0;
  ledger_.external += energy() - before;  // whoever pushes does the work
}

void LatticeSimulation::set_drive(const Drive& drive) {
  require_drive(drive, drive_, section_);
  take_forces(drive, outside_);
}

void LatticeSimulation::load(const Drive& drive, const Outside& outside, const Section& section, Model& m) const {
  apply_drive(scene_, section, drive, m);
  const auto add = [&](const Array& from, Array& to) {
    for (std::size_t i = 0; i < from.size(); ++i)
      if (m.seed_of[i] >= 0) to[i] += from[i];
  };
  const StandingWater water(scene_, section, m);
  add(water.x, m.force_x), add(water.y, m.force_y);
  add(outside.external_x, m.force_x), add(outside.external_y, m.force_y);
  if (outside.pore_pressure.present()) add_pore_force(outside.pore_pressure, m);
}

void LatticeSimulation::take_forces(Drive drive, Outside outside) {
  Array kept_x = model_.force_x, kept_y = model_.force_y;
  std::vector<GuidedParticle> kept_guided = model_.guided;
  const Real kept_scale = model_.force_scale;
  try {
    load(drive, outside, section_, model_);
  } catch (...) {  // out of memory: as if nobody had asked
    model_.force_x = std::move(kept_x), model_.force_y = std::move(kept_y);
    model_.guided = std::move(kept_guided), model_.force_scale = kept_scale;
    throw;
  }
  measure_forces(model_);
  drive_ = std::move(drive), outside_ = std::move(outside);
  force_version_ = ++newest_force_version_;
}

Vec2 LatticeSimulation::boundary_reaction(std::size_t boundary) const {
  evaluate();
  const auto seed = [&](std::size_t i) -> const Seed& {
    return section_.seeds[static_cast<std::size_t>(model_.seed_of[i])];
  };
  const auto soil = [&](std::size_t i) { return seed(i).hold == Hold::kFree; };
  const auto wall = [&](std::size_t i) { return !soil(i) && static_cast<std::size_t>(seed(i).boundary) == boundary; };
  Vec2 sum = Vec2::Zero();
  const auto add = [&](std::size_t i, std::size_t j, const Vec2& force) {
    if (soil(i) && wall(j)) sum += force;
  };
  const auto nodal = [&](const Array& flux) {  // the step leaves V_i S_i M_i^-1
    Array z = flux;
    for (std::size_t i = 0; i < z.size(); ++i)
      if (model_.seed_of[i] >= 0) z[i] /= model_.volume[i];
    return z;
  };
  const Array xx = nodal(scratch_.flux_xx), xy = nodal(scratch_.flux_xy), yx = nodal(scratch_.flux_yx),
              yy = nodal(scratch_.flux_yy);
  for_each_flux_force(model_, {xx, xy, yx, yy}, add);
  if (outside_.pore_pressure.present())
    for_each_flux_force(model_, PoreFlux(model_, outside_.pore_pressure).nodal(), add);
  for_each_bond(model_, state_, scratch_, constants_, 1 / factor_, [&](const ObservedBond& b) {
    const auto i = static_cast<std::size_t>(b.i), j = static_cast<std::size_t>(b.j);
    if (i == j || !((soil(i) && wall(j)) || (soil(j) && wall(i)))) return;
    // the pair force of VB5, B_ij s n / r
    const auto place = [&](std::size_t k) { return section_.local_place(static_cast<std::size_t>(model_.seed_of[k])); };
    const Vec2 xi = place(j) - place(i);
    const Vec2 force =
        b.volume / xi.squaredNorm() * Vec2(b.sxx * xi.x() + b.sxy * xi.y(), b.sxy * xi.x() + b.syy * xi.y());
    if (soil(i)) sum += force;
    else sum -= force;
  });
  return sum;
}

FieldView LatticeSimulation::view(int field) const {
  const FieldInfo& info = fields()[static_cast<std::size_t>(field)];
  const std::string_view name = info.name;
  FieldView out;
  out.count = model_.storage, out.stride_item = sizeof(double);
  const auto pair = [&](const Array& x, const Array& y) {
    out.data = x.data();
    out.stride_component = reinterpret_cast<const char*>(y.data()) - reinterpret_cast<const char*>(x.data());
  };
  if (name == "displacement") {
    pair(state_.displacement_x, state_.displacement_y);
  } else if (name == "velocity") {
    pair(state_.velocity_x, state_.velocity_y);
  } else if (name == "mass") {
    out.data = model_.mass.data();
  } else if (name == "volume") {
    out.data = model_.volume.data();
  } else if (name == "particle_id") {
    if (storage_ids_.empty()) {
      storage_ids_.assign(static_cast<std::size_t>(model_.storage), -1);
      for (std::size_t k = 0; k < model_.id_of.size(); ++k)
        storage_ids_[static_cast<std::size_t>(model_.storage_of[k])] = model_.id_of[k];
    }
    out.data = storage_ids_.data();
  } else {
    throw Error(Status::kUnsupported, std::string("field '") + info.name +
                                          "' is not stored as such: read a copy; displacement, velocity, mass, volume "
                                          "and particle_id can be viewed");
  }
  return out;
}

}  // namespace vbgpd
