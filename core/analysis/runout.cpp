// From the state handed over to rest: gravity without strengths where there is no stress yet, then true dynamics.
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/runout_shape.h"
#include "analysis/section_ends.h"
#include "analysis/slice_job.h"
#include "scene/wording.h"

namespace vbgpd {

namespace {

constexpr Real kEquilibrium = 1e-5;  // unbalanced force ratio of the gravity state
constexpr Real kRest = 1e-6;         // kinetic energy over its peak
constexpr Real kStanding = 1e-9;     // kinetic energy over weight x height: it stands still
constexpr Real kSetOut = 1e-6;       // ... of its peak, beyond which the slope has set out
constexpr std::int64_t kSlice = 20;  // steps between two looks

class RunoutJob final : public SliceJob {
 public:
  using SliceJob::SliceJob;

 private:
  Slices analysis() override {
    result_.scheme = scheme();
    result_.flow_rule = "non-associated, dilatancy angle 0";
    progress_.strength_reduction_factor = simulation_.get("strength_reduction_factor");
    // the time a body falls through the section's height
    const Real height = simulation_.get("area") / width(), gravity = simulation_.scene().gravity;
    const Real fall = std::sqrt(std::max(height, simulation_.get("height")) / gravity);
    if (without_stress())
      for (Slices s = apply_gravity(20 * fall); s.next();) co_yield Pause{};
    if (outcome_ == Status::kDiverged) co_return;
    for (Slices s = run_out(fall); s.next();) co_yield Pause{};
  }

  const char* scheme() const {
    const std::string& bond = simulation_.scene().bond;
    if (bond == "none") return "corrected SPH, no bonds, updated-Lagrangian";
    if (bond == "sph") return "plain SPH (Libersky & Petschek 1991), artificial viscosity";
    if (bond == "sph_artificial_stress") return "plain SPH with artificial stress (Gray, Monaghan & Swift 2001)";
    if (bond == "pseudo_spring") return "pseudo-spring SPH (Chakraborty & Shaw 2013)";
    if (bond == "gpd") return "general particle dynamics: plain SPH with particles that die (Zhou et al. 2015)";
    return "VB-GPD: hourglass virtual bonds, updated-Lagrangian";
  }

  Real width() const {
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    for (const Point& p : simulation_.scene().exterior) low = std::min(low, p.x), high = std::max(high, p.x);
    return high - low;
  }

  bool without_stress() const {
    std::vector<double> stress;
    simulation_.read(find_field("stress"), stress);
    return std::all_of(stress.begin(), stress.end(), [](double s) { return s == 0; });
  }

  Slices apply_gravity(Real longest) {
    progress_.phase = Phase::kGravity;
    RelaxOptions elastic;
    elastic.elastic = true;
    const Real time_step = simulation_.get("time_step");
    const std::shared_ptr<SavedState> before = simulation_.save();
    for (std::int64_t n = 0; static_cast<Real>(n) * time_step < longest; n += kSlice) {
      const RelaxReport r = simulation_.relax(kSlice, elastic);
      progress_.steps += r.steps, progress_.unbalanced_force_ratio = r.unbalanced_force_ratio;
      if (r.diverged) {
        simulation_.restore(*before);
        diverge();
        co_return;
      }
      gravity_ratio_ = r.unbalanced_force_ratio;
      if (gravity_ratio_ < kEquilibrium) break;
      co_yield Pause{};
    }
    simulation_.halt();
  }

  Slices run_out(Real fall) {
    progress_.phase = Phase::kRunout;
    const Real end = option("end_time"), longest = 200 * fall;
    const Real begun = simulation_.get("time");
    weight_height_ = simulation_.get("total_mass") * simulation_.scene().gravity * simulation_.get("height");
    // a model that had come to rest may have been driven anew: it is given time to set out again
    const bool rested = has_come_to_rest() || (begun > 2 * fall && never_set_out());
    const Real earliest = rested ? begun + 2 * fall : begun;
    for (;;) {
      const Real time = simulation_.get("time");
      progress_.unbalanced_force_ratio = simulation_.get("unbalanced_force_ratio");
      progress_.fraction = end > 0 ? std::min(1.0, time / end) : 0;
      if (time > earliest && has_come_to_rest()) {
        at_rest("the kinetic energy fell below 1e-6 of its peak");
        break;
      }
      if (time > earliest && stands(time, fall)) break;
      if (end > 0 && time >= end) {
        result_.status = "TIME_REACHED", result_.reason = "the end time was reached; " + kinetic_energy_now();
        break;
      }
      if (end == 0 && time - begun > longest) {
        result_.status = "NOT_CONVERGED", outcome_ = Status::kNotConverged;
        result_.reason = "not at rest after " + number_text(time, 4) + " s; " + kinetic_energy_now();
        break;
      }
      std::int64_t left = kSlice;
      const auto slice = [&left] { return left-- > 0 ? Status::kOk : Status::kLimitReached; };
      const StepReport r = end > 0 ? simulation_.advance_to(end, slice) : simulation_.step(kSlice, nullptr);
      progress_.steps += r.steps;
      if (r.status == Status::kDiverged) {
        diverge();
        co_return;
      }
      co_yield Pause{};
    }
    conclude();
  }

  Real kinetic() const { return simulation_.get("kinetic_energy"); }
  Real peak() const { return simulation_.get("peak_kinetic_energy"); }

  bool has_come_to_rest() const { return kinetic() < kRest * peak() && peak() > kSetOut * weight_height_; }

  bool never_set_out() const { return peak() < kSetOut * weight_height_ && kinetic() < kStanding * weight_height_; }

  /// A slope that never set out: it stands still, or vibrates without going any farther (elastic waves hardly fade).
  bool stands(Real time, Real fall) {
    constexpr Real kStays = 0.5;  // spacings
    constexpr Real kLong = 4;     // times of fall
    const Real spacing = std::sqrt(simulation_.get("spacing_x") * simulation_.get("spacing_y"));
    const Real standing = simulation_.get("standing_time");
    if (time > 2 * fall && never_set_out()) {
      at_rest("the slope stands: it never set out");
      return true;
    }
    if (standing < kLong * fall || simulation_.get("max_displacement") > kStays * spacing ||
        kinetic() > kSetOut * weight_height_)
      return false;
    at_rest("the slope stands: it vibrates, and went no farther for " + number_text(standing, 3) + " s");
    return true;
  }

  void at_rest(std::string reason) { result_.status = "AT_REST", result_.reason = std::move(reason); }

  std::string kinetic_energy_now() const {
    return "the kinetic energy is " + number_text(kinetic(), 2) + " J/m" +
           (peak() > 0 ? ", " + number_text(kinetic() / peak(), 2) + " of its peak" : "");
  }

  void diverge() {
    outcome_ = Status::kDiverged, result_.status = "DIVERGED";
    result_.reason = "a particle crossed a spacing in one step; the model is back at its last good step";
  }

  void conclude() {
    const RunoutShape shape = runout_shape(simulation_);
    result_.crest_settlement = shape.crest_settlement, result_.toe_displacement = shape.toe_displacement;
    result_.runout_distance = shape.runout_distance, result_.moved_area = shape.moved_area;
    result_.plastic_fraction = shape.plastic_fraction;
    result_.energy_residual = simulation_.get("energy_residual");
    result_.max_displacement = progress_.max_displacement = simulation_.get("max_displacement");
    result_.displacement_level = simulation_.get("displacement_level");
    result_.unbalanced_force_ratio = progress_.unbalanced_force_ratio;
    if (!std::isnan(shape.stopped_at))
      result_.reason += "; the front has come up to the end of the section at x = " + number_text(shape.stopped_at) +
                        " m: a longer section would let it go farther";
    tell_of_ends(shape.stopped_at);
    if (gravity_ratio_ >= kEquilibrium)
      result_.reason += "; the gravity state it set out from was not at rest (unbalanced force ratio " +
                        number_text(gravity_ratio_, 2) + ")";
    tell_of_water();
    constexpr Real kBalanced = 0.01;
    if (result_.energy_residual > kBalanced)
      result_.reason += "; the energy ledger misses " + number_text(100 * result_.energy_residual, 2) + " %";
  }

  /// Soil that moves where the section ends would take more soil along if there were more.
  void tell_of_ends(Real told) {
    constexpr Real kNear = 1.5, kUpright = 3, kShare = 0.1;  // spacings, twice; of the largest displacement
    std::vector<double> before, moved;
    simulation_.read(find_field("reference_position"), before), simulation_.read(find_field("displacement"), moved);
    const Real near = kNear * simulation_.get("spacing_x");
    for (const SectionEnd& end :
         upright_ends(simulation_.section().exterior, kUpright * simulation_.get("spacing_y"))) {
      Real most = 0;
      for (std::size_t i = 0; i + 1 < before.size(); i += 2)
        if (std::fabs(before[i] - end.x) < near) most = std::max(most, std::hypot(moved[i], moved[i + 1]));
      if (end.x != told && most > std::max(near / 3, kShare * result_.max_displacement))
        result_.reason += "; the soil at the end of the section at x = " + number_text(end.x) + " m moved by " +
                          number_text(most, 2) + " m: where the ground goes on there, use a longer section";
    }
  }

  /// Pore pressures are lost where soil comes apart, but nothing drains: high ones may still push more than water
  /// would.
  void tell_of_water() {
    std::vector<double> pressure, mass, now, before;
    const auto read = [&](const char* name, std::vector<double>& to) { simulation_.read(find_field(name), to); };
    read("pore_pressure", pressure);
    const bool dry = std::all_of(pressure.begin(), pressure.end(), [](double p) { return p == 0; });
    const Drive& drive = simulation_.drive();
    if (dry || !drive.loads.empty() || drive.kh != 0 || !(peak() > kSetOut * weight_height_)) return;
    read("mass", mass), read("position", now), read("reference_position", before);
    Real weight = 0;
    for (std::size_t i = 0; i < mass.size(); ++i)
      weight -= mass[i] * simulation_.scene().gravity * (now[2 * i + 1] - before[2 * i + 1]);
    const Real water = simulation_.get("external_work") - weight;
    if (water <= std::max<Real>(weight, 0)) return;
    result_.reason +=
        "; the pore pressures, which stay on the particles until these come apart, did more work than the weight: they "
        "lift soil that would drain";
  }

  Real weight_height_ = 0;  ///< of the section, J/m
  Real gravity_ratio_ = 0;  ///< unbalanced force ratio of the gravity state, where one was made
};

}  // namespace

std::unique_ptr<Job> make_runout_job(Simulation& simulation) {
  if (!simulation.runs_out())
    throw Error(Status::kState,
                "a run-out needs a run-out model: make one from this model with vbgpd_model_create_runout");
  return std::make_unique<RunoutJob>(simulation);
}

}  // namespace vbgpd
