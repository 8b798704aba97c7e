#include "simulation/lattice_simulation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/wording.h"
#include "simulation/build_model.h"
#include "simulation/ground_water.h"

namespace vbgpd {

namespace {

/// Fraction of the stable time step that is used: what the measurement may still miss of omega_max comes off it.
constexpr Real kStepMargin = 0.96;

Real largest_square(const Array& x, const Array& y) {
  Real largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, x[i] * x[i] + y[i] * y[i]);
  return largest;
}

std::size_t bytes_of(const Outside& o) { return o.external_x.bytes() + o.external_y.bytes() + o.pore_pressure.bytes(); }

}  // namespace

struct LatticeSimulation::Saved final : SavedState {
  State state;
  Real factor = 1, damping = 0, time_step_factor = kDefaultTimeStepFactor, time = 0, last_time_step = 0;
  std::int64_t steps = 0, since_restart = 0;
  Ledger ledger;
  Drive drive;
  Outside outside;
  Layers layers;
  std::uint64_t force_version = 0;
  std::optional<SavedBytes> counted;
};

LatticeSimulation::LatticeSimulation(const SceneDef& scene, const CompileOptions& options, const Kernels& kernels)
    : scene_(scene), options_(options), kernels_(kernels), workers_(options.threads) {
  const auto lattice_of = [&](Real spacing) {
    const Lattice fitted = fit_lattice(scene, spacing * options.spacing_factor, options.lattice_multiple);
    return options.coarsening > 1 ? coarsened(fitted, options.coarsening) : fitted;
  };
  require_bytes(scene, lattice_of, scene.spacing, kernels.width, options.max_bytes);
  const bool own_spacing = options.spacing_factor == 1 && options.coarsening == 1;  // not a grid of a job
  section_ = own_spacing ? section_within(scene, lattice_of, scene.spacing, options.max_particles)
                         : discretise(scene, lattice_of(scene.spacing), support_reach(scene), options.max_particles);
  model_ = build_model(scene_, section_, kernels.width, options.heap);
  drive_ = scene_drive(scene_, section_);
  state_.allocate(model_);
  scratch_.allocate(model_);
  partial_.resize(model_.chunks.size());
  set_factor(1);
  elastic_constants_ = pair_constants(model_, 1, true);
  if (const std::vector<double> water = scene_pore_pressure(scene_, section_); !water.empty())
    LatticeSimulation::write(find_field("pore_pressure"), water);
}

void LatticeSimulation::set_factor(Real factor) { take_constants(factor, pair_constants(model_, factor, false)); }

void LatticeSimulation::take_constants(Real factor, std::vector<LawConstants> constants) {
  factor_ = factor;
  audit_.valid = false;
  fit_dilation_cap(model_, constants, dilation_cap_);
  constants_ = std::move(constants);
}

void LatticeSimulation::fit_dilation_cap(const Model& m, const std::vector<LawConstants>& constants, Array& cap) {
  if (!m.features.volumetric_plastic) return;
  if (!cap.present()) cap.allocate(static_cast<std::size_t>(m.storage), 12, m.heap);
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.storage); ++i) {
    if (m.seed_of[i] < 0) continue;
    const LawConstants& c = constants[static_cast<std::size_t>(m.material[i] * m.materials + m.material[i])];
    cap[i] = c.t / c.bulk_modulus;
  }
}

StepData LatticeSimulation::data(State& s, Scratch& t) const {
  StepData d{};
  const Model& m = model_;
  d.offsets = m.offsets.data(), d.packs = m.packs.data(), d.neighbours = m.neighbours.data(),
  d.blocks = m.blocks.data();
  d.chunks = m.chunks.data(), d.chunk_count = static_cast<int>(m.chunks.size());
  d.guided = m.guided.data(), d.guided_count = static_cast<int>(m.guided.size());
  d.volume = m.volume.data(), d.share = m.share.data();
  d.moment_xx = m.moment_xx.data(), d.moment_xy = m.moment_xy.data(), d.moment_yy = m.moment_yy.data();
  d.sum_x = m.sum_x.data(), d.sum_y = m.sum_y.data();
  d.weighted_x = t.weighted_x.data(), d.weighted_y = t.weighted_y.data();
  d.force_x = m.force_x.data(), d.force_y = m.force_y.data(), d.free_x = m.free_x.data(), d.free_y = m.free_y.data();
  d.extra_cohesion = m.extra_cohesion.data(), d.compressibility = m.compressibility.data();
  d.place_x = m.place_x.data(), d.place_y = m.place_y.data();
  d.pair_weight = m.pair_weight.data(), d.forward_packs = m.forward_packs;
  d.least_r2 = 1e-12 * section_.lattice.spacing.prod();
  d.uses_algorithm[0] = m.features.has_algorithm[0], d.uses_algorithm[1] = m.features.has_algorithm[1];
  d.ux = s.displacement_x.data(), d.uy = s.displacement_y.data(), d.vx = s.velocity_x.data(),
  d.vy = s.velocity_y.data();
  d.plastic_volume = s.plastic_volume.data(), d.gap = s.gap.data();
  d.plastic_strain = d.plastic_strain_to = s.plastic_strain.data();
  d.lxx = t.gradient_xx.data(), d.lxy = t.gradient_xy.data(), d.lyx = t.gradient_yx.data(),
  d.lyy = t.gradient_yy.data();
  d.dilation = t.dilation.data();
  d.zxx = t.flux_xx.data(), d.zxy = t.flux_xy.data(), d.zyx = t.flux_yx.data(), d.zyy = t.flux_yy.data();
  d.px = t.pair_force_x.data(), d.py = t.pair_force_y.data(), d.volume_source = t.volume_source.data();
  return d;
}

void LatticeSimulation::run_step(StepData data, const Controls& controls, Sums& sums) const {
  const bool bonded = model_.features.bond != BondLaw::kNone;
  if (controls.ledger) {
    scratch_.keep_books(model_);
    data.opening = scratch_.opening.data(), data.mean_load = scratch_.mean_load.data();
  }
  kernels_.step(bonded, model_.off_lattice(), controls.ledger)(data, controls, workers_, partial_.data(), sums);
}

Real LatticeSimulation::dynamic_time_step() const {
  if (dynamic_frequency_ == 0) dynamic_frequency_ = highest_frequency(model_.mass);
  return time_step_factor_ * 2 / dynamic_frequency_;
}

Controls LatticeSimulation::evaluation_controls() const {
  Controls c;
  c.mass = model_.mass.data();  // without a kick any will do
  c.constants = constants_.data();
  c.dilation_cap = dilation_cap_.data();
  c.cohesion_scale = 1 / factor_;
  return c;
}

Sums LatticeSimulation::probe(const Controls& controls) const {
  probe_.take_motion(state_);
  StepData d = data(probe_, scratch_);
  d.plastic_strain = state_.plastic_strain.data();
  Sums sums;
  run_step(d, controls, sums);
  return sums;
}

Sums LatticeSimulation::evaluate() const { return probe(evaluation_controls()); }

Real LatticeSimulation::half_step_work() const {
  Controls c = evaluation_controls();
  c.time_step = last_time_step_ > 0 ? last_time_step_ : dynamic_time_step();
  c.ledger = true;
  const Sums sums = probe(c);
  return sums.internal_work / 2 + sums.plastic_work;
}

Real LatticeSimulation::unbalanced_force_ratio(const Sums& sums) const {
  return model_.force_scale > 0 ? sums.unbalanced / model_.force_scale : 0;
}

Monitors LatticeSimulation::monitors() const { return monitors_of(unbalanced_force_ratio(evaluate())); }

Monitors LatticeSimulation::monitors_after(const StepReport& steps) const {
  return steps.unbalanced_force_ratio ? monitors_of(*steps.unbalanced_force_ratio) : monitors();
}

Monitors LatticeSimulation::monitors_of(Real unbalanced_force_ratio) const {
  Monitors out;
  out.unbalanced_force_ratio = unbalanced_force_ratio;
  out.max_displacement = std::sqrt(largest_square(state_.displacement_x, state_.displacement_y));
  out.max_velocity = std::sqrt(largest_square(state_.velocity_x, state_.velocity_y));
  out.kinetic_energy = kinetic_energy();
  out.plastic_bonds = vbgpd::plastic_bonds(model_, state_);
  return out;
}

void LatticeSimulation::halt() {
  unbook();
  state_.velocity_x.fill_zero();
  state_.velocity_y.fill_zero();
  since_restart_ = 0;
}

void LatticeSimulation::start_over() {
  unbook();
  State::for_each_array(state_, [](const char*, Array& a) { a.fill_zero(); });
  since_restart_ = 0;
}

RelaxReport LatticeSimulation::relax(std::int64_t steps, const RelaxOptions& options) {
  unbook();
  const Workers::Session session(workers_);
  if (relaxing_frequency_ == 0) relaxing_frequency_ = highest_frequency(model_.scaled_mass);
  Controls c;
  c.mass = model_.scaled_mass.data();
  c.constants = options.elastic ? elastic_constants_.data() : constants_.data();
  c.dilation_cap = options.elastic ? nullptr : dilation_cap_.data();
  c.cohesion_scale = 1 / factor_;
  c.local_damping = options.local_damping;
  c.ledger = options.ledger;
  RelaxReport r;
  Sums sums;
  const Real runaway = 1e4 * section_.lattice.spacing.norm() + 1e6 * displacement_scale();
  for (std::int64_t n = 0; n < steps; ++n) {
    // Nesterov-like momentum b, dropped when the forces turn against the motion. A step is stable while
    // (omega dt)^2 < 2 (1 + b): plain descent right after a restart takes shorter ones. Local damping has its own
    // limit.
    const bool damped = options.local_damping > 0;
    c.momentum = damped ? 1 : static_cast<Real>(since_restart_) / static_cast<Real>(since_restart_ + 3);
    c.time_step =
        options.time_step_factor * kStepMargin * std::sqrt(2 * (damped ? 1 : 1 + c.momentum)) / relaxing_frequency_;
    c.kick = c.time_step;
    run_step(data(state_, scratch_), c, sums);
    ++since_restart_;
    if (options.local_damping == 0 && sums.power < 0) since_restart_ = 0;
    ++r.steps;
    r.external_work += sums.external_work, r.internal_work += sums.internal_work, r.plastic_work += sums.plastic_work;
    if (!(sums.displacement2 < runaway * runaway) || !std::isfinite(sums.unbalanced)) {
      r.diverged = true;
      break;
    }
  }
  r.since_restart = since_restart_;
  r.unbalanced_force_ratio = unbalanced_force_ratio(sums);
  r.external_power = sums.external_power;
  r.power_ratio = sums.external_power != 0 ? 1 - sums.power / sums.external_power : 0;
  r.velocity = std::sqrt(sums.velocity2);
  r.max_displacement = std::sqrt(sums.displacement2);
  return r;
}

std::shared_ptr<SavedState> LatticeSimulation::save() const {
  auto saved = std::make_shared<Saved>();
  saved->state = state_;
  saved->factor = factor_, saved->time = time_, saved->steps = steps_, saved->since_restart = since_restart_;
  saved->damping = damping_, saved->time_step_factor = time_step_factor_;
  saved->last_time_step = last_time_step_, saved->ledger = ledger_;
  saved->drive = drive_, saved->outside = outside_, saved->force_version = force_version_;
  saved->layers = layers_;
  saved->counted.emplace(saved_, saved->state.bytes() + bytes_of(saved->outside));
  return saved;
}

void LatticeSimulation::restore(const SavedState& other) {
  const auto& saved = dynamic_cast<const Saved&>(other);
  const bool placed = saved.state.placed_strain.present();
  if (saved.layers != layers_ || placed != model_.features.placed) {
    Drive drive = saved.drive;
    Outside outside = saved.outside;
    Stage other = stage(saved.layers, placed, drive, outside, saved.factor);
    other.state = saved.state;
    exchange(other);
    factor_ = saved.factor;
    drive_ = std::move(drive), outside_ = std::move(outside), force_version_ = saved.force_version;
  } else {
    std::optional<std::vector<LawConstants>> constants;  // nothing is taken from the heap where only the state differs
    if (saved.factor != factor_) constants = pair_constants(model_, saved.factor, false);
    if (saved.force_version != force_version_) {
      take_forces(saved.drive, saved.outside);
      force_version_ = saved.force_version;
    }
    if (constants) take_constants(saved.factor, *std::move(constants));
    audit_.valid = false;
    state_ = saved.state;
  }
  time_ = saved.time, steps_ = saved.steps, since_restart_ = saved.since_restart;
  damping_ = saved.damping, time_step_factor_ = saved.time_step_factor;
  last_time_step_ = saved.last_time_step, ledger_ = saved.ledger;
}

Memory LatticeSimulation::memory() const {
  Memory m;
  m.model = model_.bytes() + section_.seeds.capacity() * sizeof(Seed) + section_.shifts.capacity() * sizeof(Vec2) +
            section_.cut_pairs.capacity() * sizeof(CutPair);
  m.state = state_.bytes();
  m.scratch = scratch_.bytes() + dilation_cap_.bytes() + partial_.capacity() * sizeof(Sums);
  m.copies = probe_.bytes() + audit_.state.bytes() + storage_ids_.capacity() * sizeof(std::int64_t);
  m.outside = bytes_of(outside_);
  m.saved = *saved_;
  return m;
}

Real LatticeSimulation::elastic_energy() const {
  evaluate();
  return vbgpd::elastic_energy(model_, state_, scratch_, constants_, 1 / factor_);
}

void LatticeSimulation::set(std::string_view name, double value) {
  require_settable(name, value);
  if (name == "damping") damping_ = value;
  if (name == "time_step_factor") time_step_factor_ = value;
  if (name == "strength_reduction_factor") set_factor(value);
  if (name == "kh" || name == "kv") {
    Drive changed = drive_;
    (name == "kh" ? changed.kh : changed.kv) = value;
    set_drive(changed);
  }
}

double LatticeSimulation::get(std::string_view name) const {
  if (name == "damping") return damping_;
  if (name == "time_step_factor") return time_step_factor_;
  if (name == "strength_reduction_factor") return factor_;
  if (name == "kh") return drive_.kh;
  if (name == "kv") return drive_.kv;
  if (name == "time") return time_;
  if (name == "steps") return static_cast<double>(steps_);
  if (name == "time_step") return dynamic_time_step();
  if (name == "stable_time_step") return dynamic_time_step() / time_step_factor_;
  if (name == "unbalanced_force_ratio") return monitors().unbalanced_force_ratio;
  if (name == "max_displacement") return monitors().max_displacement;
  if (name == "max_velocity") return monitors().max_velocity;
  if (name == "displacement_level") return monitors().max_displacement / displacement_scale();
  if (name == "total_mass") {
    double sum = 0;
    for (std::size_t k = 0; k < section_.seeds.size(); ++k)
      if (section_.seeds[k].hold == Hold::kFree) sum += model_.mass[static_cast<std::size_t>(model_.storage_of[k])];
    return sum;
  }
  if (name == "area") return section_.area;
  if (name == "height") return section_.height;
  if (name == "spacing_x") return section_.lattice.spacing.x();
  if (name == "spacing_y") return section_.lattice.spacing.y();
  if (name == "particles") return static_cast<double>(model_.particles);
  if (name == "bonds") return static_cast<double>(model_.bonds);
  if (name == "plastic_bonds") return static_cast<double>(vbgpd::plastic_bonds(model_, state_));
  if (name == "bytes") return static_cast<double>(memory().total());
  if (name == "kinetic_energy") return kinetic_energy();
  if (name == "elastic_energy") return elastic_energy();
  if (name == "plastic_dissipation") return ledger_.plastic;
  if (name == "damping_dissipation") return ledger_.damping;
  if (name == "external_work") return ledger_.external;
  if (name == "energy_residual") return energy_residual();
  no_such_value(name);
}

}  // namespace vbgpd
