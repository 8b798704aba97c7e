#include "simulation/flow_simulation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/wording.h"
#include "simulation/build_flow.h"
#include "smoothing/kernels.h"
#include "state/flow_drift.h"
#include "state/flow_neighbours.h"

namespace vbgpd {

struct FlowSimulation::Saved final : SavedState {
  FlowState state;
  FlowSums last;
  Ledger ledger;
  Real factor = 1, damping = 0, time = 0, peak_kinetic = 0, farthest = 0, farther_at = 0;
  std::int64_t steps = 0;
  Drive drive;
  Outside outside;
  std::optional<SavedBytes> counted;
};

namespace {

constexpr Real kBlank = 1e100;  // where the particle is that fills up packs: out of everyone's reach
constexpr int kChunk = 128;     // particles a thread takes at a time

std::size_t bytes_of(const Outside& o) { return o.external_x.bytes() + o.external_y.bytes() + o.pore_pressure.bytes(); }

/// sum V omega of a particle in the middle of a lattice, m-2; omega = -W'(r)/r.
Real full_neighbourhood(Real spacing, Real h) {
  const int reach = static_cast<int>(2 * h / spacing);
  Real sum = 0;
  for (int a = -reach; a <= reach; ++a)
    for (int b = -reach; b <= reach; ++b) {
      const Real r = std::hypot(a, b) * spacing;
      if (r > 0) sum -= spacing * spacing * WendlandC2::derivative(r, h) / r;
    }
  return sum;
}

}  // namespace

FlowSimulation::FlowSimulation(const LatticeSimulation& from, const FlowOptions& options, const FlowKernels& kernels)
    : scene_(from.scene()),
      options_(from.options()),
      section_(from.section()),
      layers_(from.layers()),
      kernels_(kernels),
      model_(build_flow_model(from, options)),
      state_(handed_over(from, model_)),
      workers_(from.options().threads) {
  partial_.resize(static_cast<std::size_t>((model_.particles + kChunk - 1) / kChunk));
  for (std::size_t k = 0; k < model_.law.size(); ++k) {
    const bool soil = yields(model_.law[k]);
    yields_ |= soil;
    bond_modulus_.push_back((soil ? options.bond_stiffness : options.elastic_bond_stiffness) *
                            model_.moduli[k].shear_modulus);
    FlowLaw elastic;
    elastic.constants = model_.moduli[k];
    elastic_laws_.push_back(elastic);
  }
  set_factor(from.get("strength_reduction_factor"));
  take_forces(from.drive(), handed_over_forces(from, model_));
  state_was_changed();
  fit_guard();
  join();
}

/// Particles of cut cells may start nearer to each other or to a wall than the guard allows: theirs gets smaller, so
/// that nothing is pushed apart before anything moved.
void FlowSimulation::fit_guard() {
  const Real b = model_.options.guard_distance;
  if (!(b > 0)) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i) {
    const double* const x = state_.motion.data() + 4 * i;
    Real& size = model_.size[static_cast<std::size_t>(state_.particle[i])];
    for (auto k = 4 * static_cast<std::size_t>(lists_.rows[i].begin);
         k < 4 * static_cast<std::size_t>(lists_.rows[i].ghosts); ++k) {
      if (lists_.neighbours[k] >= model_.particles) continue;
      const double* const y = state_.motion.data() + 4 * static_cast<std::size_t>(lists_.neighbours[k]);
      size = std::min(size, std::hypot(y[0] - x[0], y[1] - x[1]) / b);
    }
    for (const FlowWall& w : model_.walls)
      size = std::min(size, 2 / b * std::max<Real>(0, (x[0] - w.x) * w.nx + (x[1] - w.y) * w.ny));
  }
  list_neighbours(model_, state_, lists_);
}

void FlowSimulation::join() {
  if (model_.bond == FlowBondLaw::kPseudoSpring) join_neighbours(model_, state_, lists_);
}

void FlowSimulation::state_was_changed() {
  const auto prepare = [this](const FlowLists& found) { arrange(found, scratch_); };
  if (search_neighbours(model_, state_, lists_, prepare)) ++epoch_, storage_ids_.clear();
  ++searches_;
  room_ = model_.options.skin * model_.spacing / 2;
}

void FlowSimulation::set_factor(Real factor) {
  factor_ = factor, farther_at_ = time_;
  laws_.clear();
  for (std::size_t k = 0; k < model_.law.size(); ++k) {
    FlowLaw law;
    const Strength strength = reduced(model_.strength[k], factor);
    std::visit([&](auto l) { decltype(l)::derive(strength, law.constants); }, model_.law[k]);
    law.constants.shear_modulus = model_.moduli[k].shear_modulus;
    law.constants.bulk_modulus = model_.moduli[k].bulk_modulus;
    law.algorithm = static_cast<int>(algorithm_of(model_.law[k]));
    if (yields(model_.law[k]))
      law.loose = model_.options.loose * full_neighbourhood(model_.spacing, model_.support / 2);
    if (model_.bond == FlowBondLaw::kPseudoSpring && yields(model_.law[k])) {
      // it does not yield: its springs break at the uniaxial strength in tension, or at the tension cut-off if lower
      const Real sine = std::sin(strength.friction_angle);
      const Real tension = 2 * strength.cohesion * std::cos(strength.friction_angle) / (1 + sine);
      const Real g = model_.moduli[k].shear_modulus, b = model_.moduli[k].bulk_modulus;
      law.breaking_stretch = std::min(tension, strength.tension_cutoff) * (3 * b + g) / (9 * b * g);
      law.constants = model_.moduli[k], law.algorithm = 0;
    }
    laws_.push_back(law);
  }
}

void FlowSimulation::arrange(const FlowLists& lists, FlowScratch& scratch) const {
  const auto n = static_cast<std::size_t>(model_.particles), all = n + lists.ghosts.size() + 1;
  const bool diffuses = kernels_.step[static_cast<int>(model_.bond)][1] != nullptr;
  int stagger = 3;
  // with room for more, so that not every search asks for memory; what there is serves on where there is no more
  const auto fit = [&](Array& a, std::size_t needed) {
    Array larger;
    if (a.size() < needed) larger.allocate(needed + needed / 8, stagger, model_.heap), a = std::move(larger);
    ++stagger;
  };
  for (Array* a : {&scratch.motion, &scratch.next_motion, &scratch.gradient, &scratch.bond, &scratch.inverse,
                   &scratch.flux, &scratch.slope_x, &scratch.slope_y}) {
    const bool slope = a == &scratch.slope_x || a == &scratch.slope_y;
    if (slope && !diffuses) continue;
    fit(*a, 4 * all);
  }
  if (model_.bond == FlowBondLaw::kArtificialStress && scratch.artificial.size() != 4 * (n + 1))
    scratch.artificial.allocate(4 * (n + 1), stagger++, model_.heap);
  if (scratch.next_stress.size() != 4 * (n + 1)) scratch.next_stress.allocate(4 * (n + 1), stagger++, model_.heap);
  if (model_.bond == FlowBondLaw::kVirtual && scratch.pair_force.size() != 2 * n)
    scratch.pair_force.allocate(2 * n, stagger++, model_.heap);
  fit(scratch.weight, 4 * (lists.ghosts.size() + 1));
  fit(scratch.pairs, 4 * lists.neighbours.size());
  for (Array* a : {&scratch.gradient, &scratch.bond, &scratch.flux, &scratch.slope_x, &scratch.slope_y})
    for (std::size_t k = 0; a->present() && k < 4; ++k) (*a)[4 * n + k] = 0;
  for (std::size_t k = 0; k < 4; ++k) scratch.motion[4 * n + k] = k < 2 ? kBlank : 0;
  for (std::size_t i = 0; i < n; ++i) {
    scratch.bond[4 * i + 2] = bond_modulus_[static_cast<std::size_t>(lists.soil[i])];
    scratch.bond[4 * i + 3] = lists.volume[i];
  }
}

FlowData FlowSimulation::data(FlowState& s) const {
  FlowData d{};
  d.particles = static_cast<int>(model_.particles), d.ghost_count = static_cast<int>(lists_.ghosts.size());
  d.wall_count = static_cast<int>(model_.walls.size()), d.chunk = kChunk;
  d.rows = lists_.rows.data(), d.neighbours = lists_.neighbours.data(), d.ghosts = lists_.ghosts.data();
  d.walls = model_.walls.data(), d.soil = lists_.soil.data();
  d.constants = lists_.constants.data(), d.volume = lists_.volume.data(), d.force = lists_.force.data();
  d.extra_cohesion = lists_.extra_cohesion.data();
  d.pore_pressure = lists_.pore_pressure.data();
  d.stress = s.stress.data(), d.gap = s.gap.data(), d.plastic_strain = s.plastic_strain.data();
  d.wall_shear = s.wall_shear.data(), d.wall_limit = s.wall_limit.data(), d.traction = s.traction.data(),
  d.dead = s.dead.data();
  d.motion = scratch_.motion.data(), d.next_motion = scratch_.next_motion.data();
  d.next_stress = scratch_.next_stress.data(), d.gradient = scratch_.gradient.data();
  d.bond = scratch_.bond.data(), d.inverse = scratch_.inverse.data(), d.flux = scratch_.flux.data();
  d.slope_x = scratch_.slope_x.data(), d.slope_y = scratch_.slope_y.data();
  d.pair_force = scratch_.pair_force.data(), d.weight = scratch_.weight.data();
  d.artificial = scratch_.artificial.data(), d.pairs = scratch_.pairs.data();
  return d;
}

FlowControls FlowSimulation::controls() const {
  const FlowOptions& o = model_.options;
  const Real h = model_.support / 2;
  FlowControls c;
  c.time_step = model_.time_step;
  c.local_damping = damping_;
  c.inverse_support = 1 / model_.support;
  c.support2 = model_.support * model_.support;
  c.weight_scale = 35 / (4 * kPi * h * h * h * h);
  c.softening = 0.01 * h * h;
  c.viscosity = model_.viscosity;
  c.guard_distance = o.guard_distance;
  c.guard_stiffness = o.guard_stiffness;
  c.guard_reach = o.guard_distance * *std::max_element(model_.size.data(), model_.size.data() + model_.particles);
  c.diffusion = 2 * o.stress_diffusion * h;
  c.disturbed = o.disturbed;
  c.smallest_eigenvalue = o.smallest_eigenvalue;
  if (model_.bond == FlowBondLaw::kPseudoSpring) c.smallest_eigenvalue /= 4;  // a corner has three springs, not eight
  c.dashpot = 0.2 * model_.spacing;
  c.spring_reach = o.spring_reach * model_.spacing;
  c.friction_rate = o.time_step * model_.spacing / (o.friction_lag * model_.height);
  c.image_reach = model_.bond == FlowBondLaw::kPseudoSpring ? c.spring_reach : model_.support;
  c.artificial_stress = o.artificial_stress;
  const Real s = 1 - model_.spacing / model_.support;
  c.inverse_kernel_at_spacing = 1 / (s * s * s * s * (5 - 4 * s));
  c.cohesion_scale = 1 / factor_;
  c.laws = laws_.data();
  return c;
}

void FlowSimulation::refresh_neighbours(Real time_step) {
  // Looked at only once the fastest particle could have used the room up. The margin is above all round-off, so that a
  // restored run, which looks earlier, searches at the same step.
  room_ -= 1.0001 * std::sqrt(last_.velocity2) * time_step + 1e-12 * model_.spacing;
  if (room_ < 0) room_ = room_left(model_, state_, lists_);
  if (room_ < 0) state_was_changed();
}

bool FlowSimulation::evaluate(FlowState& state, const FlowControls& c, FlowSums& sums) const {
  std::copy_n(state.motion.data(), 4 * static_cast<std::size_t>(model_.particles), scratch_.motion.data());
  const auto& functions = kernels_.step[static_cast<int>(model_.bond)];
  const bool diffuse = yields_ && c.diffusion > 0 && c.laws == laws_.data() && functions[1] != nullptr;
  functions[diffuse ? 1 : 0](data(state), c, workers_, partial_.data(), sums);
  return diffuse;
}

void FlowSimulation::run_step(const FlowControls& c, FlowSums& sums) {
  const bool diffuse = evaluate(state_, c, sums);
  std::copy_n(scratch_.next_motion.data(), 4 * static_cast<std::size_t>(model_.particles), state_.motion.data());
  if (diffuse) std::swap(state_.stress, scratch_.next_stress);
  last_ = sums;
}

/// A slope that vibrates goes on by less than a thousandth of a spacing.
void FlowSimulation::note_farthest() {
  constexpr Real kFarther = 1e-3;
  const Real now = max_displacement();
  if (now > farthest_ + kFarther * model_.spacing) farthest_ = now, farther_at_ = time_;
}

void FlowSimulation::open_ledger() {
  if (ledger_.open) return;
  ledger_.open = true;
  ledger_.kinetic_before = kinetic_energy();
  ledger_.guard_before = last_.guard;
  ledger_.stored_before = stored_energy();
}

void FlowSimulation::halt() {
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.particles); ++i)
    state_.motion[4 * i + 2] = state_.motion[4 * i + 3] = 0;
}

std::shared_ptr<SavedState> FlowSimulation::save() const {
  auto saved = std::make_shared<Saved>();
  saved->state = state_, saved->last = last_, saved->ledger = ledger_;
  saved->factor = factor_, saved->time = time_, saved->steps = steps_, saved->peak_kinetic = peak_kinetic_;
  saved->damping = damping_, saved->farthest = farthest_, saved->farther_at = farther_at_;
  saved->drive = drive_, saved->outside = outside();
  saved->counted.emplace(saved_, saved->state.bytes() + bytes_of(saved->outside));
  return saved;
}

Memory FlowSimulation::memory() const {
  Memory m;
  m.model = model_.bytes() + lists_.bytes();
  m.state = state_.bytes();
  m.scratch = scratch_.bytes();
  m.copies = storage_ids_.capacity() * sizeof(std::int64_t);
  m.outside = bytes_of(outside_) + model_.pore_pressure.bytes();
  m.saved = *saved_;
  return m;
}

void FlowSimulation::restore(const SavedState& other) {
  const auto& saved = dynamic_cast<const Saved&>(other);
  FlowState state = saved.state;
  FlowLists lists;
  FlowScratch scratch;
  list_neighbours(model_, state, lists);
  lists.pore_pressure.allocate(saved.outside.pore_pressure.size(), 5, model_.heap);
  arrange(lists, scratch);
  take_forces(saved.drive, saved.outside);
  settle(std::move(state), std::move(lists), std::move(scratch));
  last_ = saved.last, ledger_ = saved.ledger;
  set_factor(saved.factor);
  time_ = saved.time, steps_ = saved.steps, peak_kinetic_ = saved.peak_kinetic;
  damping_ = saved.damping, farthest_ = saved.farthest, farther_at_ = saved.farther_at;
}

void FlowSimulation::settle(FlowState&& state, FlowLists&& lists, FlowScratch&& scratch) {
  const double* const order = state_.particle.data();
  if (!std::equal(order, order + state_.particle.size(), state.particle.data())) ++epoch_, storage_ids_.clear();
  state_ = std::move(state), lists_ = std::move(lists), scratch_ = std::move(scratch);
  place_forces(model_, state_, lists_);
  room_ = 0;  // unknown
}

std::unique_ptr<Simulation> make_runout(const Simulation& from, const FlowOptions& options) {
  const auto* const lattice = dynamic_cast<const LatticeSimulation*>(&from);
  if (lattice == nullptr)
    throw Error(Status::kState, "this model is a run-out already; make a run-out from the model it came from");
  auto made = std::make_unique<FlowSimulation>(*lattice, options);
  const double bytes = made->get("bytes");
  const std::int64_t most = from.options().max_bytes;
  if (most > 0 && bytes > static_cast<double>(most))
    throw Error(Issue{.status = Status::kLimit,
                      .object = ObjectKind::kContext,
                      .value = bytes,
                      .text = "the run-out has " + number_text(bytes, 12) + " bytes, more than the " +
                              std::to_string(most) + " allowed: allow more bytes or use a larger spacing"});
  return made;
}

}  // namespace vbgpd
