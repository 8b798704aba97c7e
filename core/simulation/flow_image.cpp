// A run-out as plain data and back. The order of the particles is part of it: sums over neighbours go by it, and the
// tractions of the bonds lie in the list that follows from the positions at the last search.
#include <algorithm>
#include <cmath>

#include "simulation/build_flow.h"
#include "simulation/flow_simulation.h"
#include "simulation/image_reader.h"
#include "state/flow_neighbours.h"

namespace vbgpd {

namespace {

/// An array of the state with as many values as the image holds, in the order of the particles.
struct Part {
  const char* name;
  Array FlowState::*array;
  int stored, first, count;  ///< values a particle has in it, the first one and how many of them this part is
};
constexpr Part kParts[] = {
    {"position", &FlowState::motion, 4, 0, 2},
    {"velocity", &FlowState::motion, 4, 2, 2},
    {"stress", &FlowState::stress, 4, 0, 4},
    {"gap", &FlowState::gap, 1, 0, 1},
    {"plastic_strain", &FlowState::plastic_strain, 1, 0, 1},
    {"wall_shear", &FlowState::wall_shear, 1, 0, 1},
    {"wall_limit", &FlowState::wall_limit, 1, 0, 1},
    {"listed", &FlowState::listed, 2, 0, 2},
    {"dead", &FlowState::dead, 1, 0, 1},
};
constexpr double kLarge = 1e300, kCount = 1e15;

std::vector<double> gathered(const Array& array, const Array& order, const Part& part) {
  std::vector<double> rows(order.size() * static_cast<std::size_t>(part.count));
  for (std::size_t i = 0; i < order.size(); ++i)
    for (int c = 0; c < part.count; ++c)
      rows[static_cast<std::size_t>(order[i]) * static_cast<std::size_t>(part.count) + static_cast<std::size_t>(c)] =
          array[i * static_cast<std::size_t>(part.stored) + static_cast<std::size_t>(part.first + c)];
  return rows;
}

void scatter(const std::vector<double>& rows, const Array& order, const Part& part, Array& array) {
  for (std::size_t i = 0; i < order.size(); ++i)
    for (int c = 0; c < part.count; ++c)
      array[i * static_cast<std::size_t>(part.stored) + static_cast<std::size_t>(part.first + c)] =
          rows[static_cast<std::size_t>(order[i]) * static_cast<std::size_t>(part.count) + static_cast<std::size_t>(c)];
}

const std::vector<double>& needed(const StateImage& image, const char* name, int components, std::size_t count) {
  const auto* values = image_rows(image, name, components, count);
  if (values == nullptr) refuse_image("lacks the array " + std::string(name));
  return *values;
}

/// Which particle is where: every id once.
void take_order(const std::vector<double>& ids, Array& order) {
  std::vector<bool> seen(order.size(), false);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool is_id = ids[i] >= 0 && ids[i] < static_cast<double>(order.size()) && ids[i] == std::floor(ids[i]);
    if (!is_id || seen[static_cast<std::size_t>(ids[i])]) refuse_image("has an order that is not one of its particles");
    seen[static_cast<std::size_t>(ids[i])] = true;
    order[i] = ids[i];
  }
}

/// Positions in spacings must fit integers of neighbour cells with room to move on.
void require_near(const Array& xy, std::size_t stored, std::size_t count, Real spacing) {
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      if (!(std::fabs(xy[stored * i + c]) < 1e9 * spacing)) refuse_image("has a particle at an impossible place");
}

}  // namespace

StateImage FlowSimulation::image() const {
  StateImage out;
  out.runs_out = true, out.particles = model_.particles, out.bonds = bond_count(), out.hash = state_hash();
  out.numbers = {{"time", time_},
                 {"steps", static_cast<double>(steps_)},
                 {"strength_reduction_factor", factor_},
                 {"damping", damping_},
                 {"peak_kinetic_energy", peak_kinetic_},
                 {"farthest", farthest_},
                 {"farther_at", farther_at_},
                 {"neighbour_searches", static_cast<double>(searches_)},
                 {"unbalanced_force", last_.unbalanced},
                 {"guard_energy", last_.guard},
                 {"yielding_area", last_.yielding},
                 {"ledger_open", ledger_.open ? 1.0 : 0.0},
                 {"external_work", ledger_.external},
                 {"internal_work", ledger_.internal},
                 {"bond_work", ledger_.bond},
                 {"viscous_dissipation", ledger_.viscous},
                 {"damping_dissipation", ledger_.damping},
                 {"contact_work", ledger_.contact},
                 {"kinetic_energy_before", ledger_.kinetic_before},
                 {"guard_energy_before", ledger_.guard_before},
                 {"stored_energy_before", ledger_.stored_before}};
  const auto plain = [](const Array& a) { return std::vector<double>(a.data(), a.data() + a.size()); };
  out.rows.push_back({"order", 1, plain(state_.particle)});
  for (const Part& part : kParts)
    if (const Array& array = state_.*part.array; array.present())
      out.rows.push_back({part.name, part.count, gathered(array, state_.particle, part)});
  out.rows.push_back({"guard_size", 1, plain(model_.size)});
  if (state_.traction.present()) out.rows.push_back({"traction", 8, plain(state_.traction)});
  if (outside_.external_x.present()) {
    std::vector<double> force;
    read(find_field("external_force"), force);
    out.rows.push_back({"external_force", 2, std::move(force)});
  }
  if (model_.pore_pressure.present()) out.rows.push_back({"pore_pressure", 1, plain(model_.pore_pressure)});
  add_layers(layers_, out);
  add_drive(drive_, out);
  return out;
}

void FlowSimulation::restore_image(const StateImage& image) {
  if (!image.runs_out) refuse_image("is of a model at rest; this one runs out");
  if (image.particles != model_.particles)
    refuse_image("is of " + std::to_string(image.particles) + " particles; this model has " +
                 std::to_string(model_.particles));
  if (layers_of(image, scene_.layers.size()) != layers_) refuse_image("is of a run-out of other layers");
  const auto n = static_cast<std::size_t>(model_.particles);
  const Real time = image_number(image, "time", 0, kLarge), steps = image_number(image, "steps", 0, kCount);
  const Real factor = image_number(image, "strength_reduction_factor", 1e-3, 1e3);
  const Real damping = image_number(image, "damping", 0, std::nextafter(1.0, 0.0));
  const Real peak = image_number(image, "peak_kinetic_energy", 0, kLarge);
  const Real farthest = image_number(image, "farthest", 0, kLarge),
             farther_at = image_number(image, "farther_at", 0, kLarge);
  const Real searches = image_number(image, "neighbour_searches", 0, kCount);
  FlowSums last;
  last.unbalanced = image_number(image, "unbalanced_force", 0, kLarge);
  last.guard = image_number(image, "guard_energy", 0, kLarge);
  last.yielding = image_number(image, "yielding_area", 0, kLarge);
  Ledger ledger;
  ledger.open = image_number(image, "ledger_open", 0, 1) != 0;
  const auto joule = [&](const char* name) { return image_number(image, name, -kLarge, kLarge); };
  ledger.external = joule("external_work"), ledger.internal = joule("internal_work"), ledger.bond = joule("bond_work");
  ledger.viscous = joule("viscous_dissipation"), ledger.damping = joule("damping_dissipation");
  ledger.contact = joule("contact_work"), ledger.kinetic_before = joule("kinetic_energy_before");
  ledger.guard_before = joule("guard_energy_before"), ledger.stored_before = joule("stored_energy_before");

  FlowModel model = model_;
  FlowState state;
  state.allocate(model);
  take_order(needed(image, "order", 1, n), state.particle);
  for (const Part& part : kParts)
    if (Array& array = state.*part.array; array.present())
      scatter(needed(image, part.name, part.count, n), state.particle, part, array);
  require_near(state.motion, 4, n, model.spacing), require_near(state.listed, 2, n, model.spacing);
  const std::vector<double>& size = needed(image, "guard_size", 1, n);
  for (std::size_t id = 0; id < n; ++id) {
    if (!(size[id] >= 0 && size[id] <= std::sqrt(model.volume[id]))) refuse_image("has an impossible guard_size");
    model.size[id] = size[id];
  }
  const auto* pushed = image_rows(image, "external_force", 2, n);
  const auto* water = image_rows(image, "pore_pressure", 1, n);
  Outside outside;
  if (pushed != nullptr) push_by(*pushed, model.heap, outside);
  if (water != nullptr) outside.pore_pressure = pressure_of(*water, model.heap);
  model.pore_pressure = outside.pore_pressure;
  Drive drive = drive_from(image, drive_);

  // the list may be no longer than positions of a real run make it
  constexpr std::int64_t kMostWork = 1000;
  if (listing_work(model, state) > kMostWork * model.particles) refuse_image("has particles on top of each other");
  FlowLists lists;
  FlowScratch scratch;
  list_neighbours(model, state, lists);
  arrange(lists, scratch);
  if (model.keeps_bonds()) {
    const std::vector<double>& traction = needed(image, "traction", 8, lists.neighbours.size() / 4);
    state.traction.allocate(traction.size(), 8, model.heap);
    std::copy(traction.begin(), traction.end(), state.traction.data());
  }
  if (state.hash() != image.hash) refuse_image("does not hold the state it says: its hash differs");

  take_forces(std::move(drive), std::move(outside));
  model_.size = std::move(model.size);
  settle(std::move(state), std::move(lists), std::move(scratch));
  set_factor(factor);
  last_ = last, ledger_ = ledger;
  damping_ = damping, time_ = time, peak_kinetic_ = peak, farthest_ = farthest, farther_at_ = farther_at;
  steps_ = static_cast<std::int64_t>(steps), searches_ = static_cast<std::int64_t>(searches);
}

}  // namespace vbgpd
