// A lattice simulation as plain data and back, by particle id: the pack width of the machine does not matter.
#include <algorithm>
#include <cmath>
#include <optional>

#include "simulation/bond_records.h"
#include "simulation/build_model.h"
#include "simulation/image_reader.h"
#include "simulation/lattice_simulation.h"

namespace vbgpd {

namespace {

/// Particle arrays between storage order and rows by id.
class ById {
 public:
  explicit ById(const Model& m) : m_(m) {}
  std::vector<double> gather(std::initializer_list<const Array*> arrays) const {
    std::vector<double> out(m_.id_of.size() * arrays.size());
    std::size_t c = 0;
    for (const Array* a : arrays) {
      for (std::size_t k = 0; k < m_.id_of.size(); ++k)
        out[static_cast<std::size_t>(m_.id_of[k]) * arrays.size() + c] =
            (*a)[static_cast<std::size_t>(m_.storage_of[k])];
      ++c;
    }
    return out;
  }
  void scatter(const std::vector<double>& rows, std::initializer_list<Array*> arrays) const {
    std::size_t c = 0;
    for (Array* a : arrays) {
      for (std::size_t k = 0; k < m_.id_of.size(); ++k)
        (*a)[static_cast<std::size_t>(m_.storage_of[k])] =
            rows[static_cast<std::size_t>(m_.id_of[k]) * arrays.size() + c];
      ++c;
    }
  }

 private:
  const Model& m_;
};

std::int32_t id_at(const Model& m, std::size_t storage) {
  return m.id_of[static_cast<std::size_t>(m.seed_of[storage])];
}

/// The plastic strain of an image in storage order; every bond it names must exist, once.
void take_plastic(const Model& m, const std::vector<StateImage::PlasticBond>& plastic, Array& strain) {
  struct Entry {
    std::int32_t a, b;
    const StateImage::PlasticBond* bond;
    bool operator<(const Entry& o) const { return a != o.a ? a < o.a : b < o.b; }
  };
  std::vector<Entry> wanted;
  for (const StateImage::PlasticBond& p : plastic) {
    if (!std::isfinite(p.xx) || !std::isfinite(p.yy) || !std::isfinite(p.xy))
      refuse_image("has a plastic strain that is not finite");
    wanted.push_back({std::min(p.a, p.b), std::max(p.a, p.b), &p});
  }
  std::sort(wanted.begin(), wanted.end());
  std::size_t found = 0;
  const auto width = static_cast<std::size_t>(m.width);
  for_each_record(m, [&](const BondPack&, int, std::size_t i, std::size_t j, std::size_t record) {
    const std::int32_t a = id_at(m, i), b = id_at(m, j);
    const Entry key{std::min(a, b), std::max(a, b), nullptr};
    const auto at = std::lower_bound(wanted.begin(), wanted.end(), key);
    if (at == wanted.end() || key < *at) return;
    strain[record] = at->bond->xx, strain[record + width] = at->bond->yy, strain[record + 2 * width] = at->bond->xy;
    ++found;
  });
  if (found != wanted.size()) refuse_image("names bonds that this section does not have");
}

}  // namespace

StateImage LatticeSimulation::image() const {
  StateImage out;
  const ById by_id(model_);
  out.particles = model_.particles, out.bonds = model_.bonds, out.hash = state_hash();
  out.numbers = {{"time", time_},
                 {"steps", static_cast<double>(steps_)},
                 {"last_time_step", last_time_step_},
                 {"since_restart", static_cast<double>(since_restart_)},
                 {"pack_width", static_cast<double>(model_.width)},
                 {"strength_reduction_factor", factor_},
                 {"damping", damping_},
                 {"time_step_factor", time_step_factor_},
                 {"external_work", ledger_.external},
                 {"damping_dissipation", ledger_.damping},
                 {"plastic_dissipation", ledger_.plastic},
                 {"energy_before", ledger_.before},
                 {"ledger_open", ledger_.open ? 1.0 : 0.0}};
  out.rows.push_back({"displacement", 2, by_id.gather({&state_.displacement_x, &state_.displacement_y})});
  out.rows.push_back({"velocity", 2, by_id.gather({&state_.velocity_x, &state_.velocity_y})});
  if (state_.plastic_volume.present())
    out.rows.push_back({"plastic_volume", 1, by_id.gather({&state_.plastic_volume})});
  if (state_.gap.present()) out.rows.push_back({"gap", 1, by_id.gather({&state_.gap})});
  if (outside_.pore_pressure.present())
    out.rows.push_back({"pore_pressure", 1, by_id.gather({&outside_.pore_pressure})});
  if (outside_.external_x.present() || outside_.external_y.present()) {
    std::vector<double> force;
    read(find_field("external_force"), force);
    out.rows.push_back({"external_force", 2, std::move(force)});
  }
  add_layers(layers_, out);
  add_drive(drive_, out);
  out.placed = model_.features.placed;
  const auto list = [&](const Array& p, std::vector<StateImage::PlasticBond>& to) {
    if (!p.present()) return;
    const auto width = static_cast<std::size_t>(model_.width);
    for_each_record(model_, [&](const BondPack&, int, std::size_t i, std::size_t j, std::size_t r) {
      if (p[r] != 0 || p[r + width] != 0 || p[r + 2 * width] != 0)
        to.push_back({id_at(model_, i), id_at(model_, j), p[r], p[r + width], p[r + 2 * width]});
    });
  };
  list(state_.plastic_strain, out.plastic);
  list(state_.placed_strain, out.placed_strain);
  return out;
}

void LatticeSimulation::restore_image(const StateImage& image) {
  if (image.runs_out) refuse_image("is of a run-out; this model is at rest");
  constexpr double kLarge = 1e300, kCount = 1e15;
  const double time = image_number(image, "time", 0, kLarge), steps = image_number(image, "steps", 0, kCount);
  const double last_step = image_number(image, "last_time_step", 0, kLarge);
  const double since_restart = image_number(image, "since_restart", 0, kCount);
  const double factor = image_number(image, "strength_reduction_factor", 1e-3, 1e3);
  const double damping = image_number(image, "damping", 0, std::nextafter(1.0, 0.0));
  const double step_factor = image_number_or(image, "time_step_factor", 1e-6, 4, kDefaultTimeStepFactor);
  Ledger ledger;
  ledger.external = image_number(image, "external_work", -kLarge, kLarge);
  ledger.damping = image_number(image, "damping_dissipation", -kLarge, kLarge);
  ledger.plastic = image_number(image, "plastic_dissipation", -kLarge, kLarge);
  ledger.before = image_number_or(image, "energy_before", -kLarge, kLarge, 0);
  ledger.open = image_number_or(image, "ledger_open", 0, 1, 1) != 0;

  const auto n = section_.seeds.size();
  if (image.particles != model_.particles)
    refuse_image("is of " + std::to_string(image.particles) + " particles; this model has " +
                 std::to_string(model_.particles));
  Drive drive = drive_from(image, drive_);
  const ById by_id(model_);  // the same whichever layers are there
  Outside outside;
  const auto storage = static_cast<std::size_t>(model_.storage);
  if (const auto* p = image_rows(image, "pore_pressure", 1, n))
    outside.pore_pressure.allocate(storage, 2, model_.heap), by_id.scatter(*p, {&outside.pore_pressure});
  if (const auto* f = image_rows(image, "external_force", 2, n)) {
    outside.external_x.allocate(storage, 3, model_.heap), outside.external_y.allocate(storage, 4, model_.heap);
    by_id.scatter(*f, {&outside.external_x, &outside.external_y});
  }

  const Layers layers = layers_of(image, scene_.layers.size());
  std::optional<Stage> other;
  if (layers != layers_ || image.placed != model_.features.placed) {
    try {
      other = stage(layers, image.placed, drive, outside, factor);
    } catch (const Error& error) {
      refuse_image("has layers that cannot be: " + error.issue().text);
    }
  }
  const Model& m = other ? other->model : model_;
  if (image.bonds != m.bonds)
    refuse_image("has " + std::to_string(image.bonds) + " bonds; this section has " + std::to_string(m.bonds));
  State state;
  state.allocate(m);
  const auto take = [&](const char* name, std::initializer_list<Array*> arrays) {
    const auto* values = image_rows(image, name, static_cast<int>(arrays.size()), n);
    if (values == nullptr) refuse_image("lacks the array " + std::string(name));
    by_id.scatter(*values, arrays);
    for (Array* a : arrays)
      for (std::size_t i = 0; i < storage; ++i)
        if (m.seed_of[i] < 0 && (*a)[i] != 0) refuse_image("has a " + std::string(name) + " where no soil is");
  };
  take("displacement", {&state.displacement_x, &state.displacement_y});
  take("velocity", {&state.velocity_x, &state.velocity_y});
  if (state.plastic_volume.present()) take("plastic_volume", {&state.plastic_volume});
  const bool from_format_1 = state.gap.present() && image_rows(image, "gap", 1, n) == nullptr;
  if (from_format_1) state.gap = Array{};  // which had opened volume in plastic_volume, and no gap in its hash
  else if (state.gap.present()) take("gap", {&state.gap});
  const auto take_strain = [&](const std::vector<StateImage::PlasticBond>& from, Array& to) {
    if (to.present()) take_plastic(m, from, to);
    else if (!from.empty()) refuse_image("has plastic strain where nothing yields");
  };
  take_strain(image.plastic, state.plastic_strain);
  take_strain(image.placed_strain, state.placed_strain);
  // the hash goes through the storage, whose padding depends on the pack width
  if (image_number(image, "pack_width", 1, 64) == m.width && hash_of(state, layers) != image.hash)
    refuse_image("does not hold the state it says: its hash differs");
  if (from_format_1) state.gap.allocate(storage, 8, m.heap);

  if (other) {
    other->state = std::move(state);
    exchange(*other);
    factor_ = factor, drive_ = std::move(drive), outside_ = std::move(outside);
    force_version_ = ++newest_force_version_;
  } else {
    std::vector<LawConstants> constants = pair_constants(model_, factor, false);
    take_forces(std::move(drive), std::move(outside));
    take_constants(factor, std::move(constants));
    state_ = std::move(state);
  }
  time_ = time, last_time_step_ = last_step, damping_ = damping, ledger_ = ledger;
  time_step_factor_ = step_factor;
  steps_ = static_cast<std::int64_t>(steps), since_restart_ = static_cast<std::int64_t>(since_restart);
}

}  // namespace vbgpd
