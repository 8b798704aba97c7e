// Factor of safety by strength reduction: a bracket per grid, coarse to fine, one estimate from all of them.
#include <algorithm>
#include <cmath>

#include "analysis/convergence.h"
#include "analysis/grid_search.h"
#include "analysis/section_ends.h"
#include "analysis/slice_job.h"
#include "analysis/stiffness_contrast.h"
#include "analysis/tension.h"
#include "geometry/thickness.h"
#include "scene/quantity.h"
#include "simulation/build_model.h"
#include "simulation/take_over.h"

namespace vbgpd {

namespace {

double length_of(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += std::hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y);
  return sum;
}

class StrengthReductionJob final : public SliceJob {
 public:
  using SliceJob::SliceJob;

 private:
  Slices analysis() override {
    describe();
    plan();
    for (std::size_t n = 0; n < most_ && goes_on(n); ++n) {
      const double wall = result_.wall_seconds, cpu = result_.cpu_seconds;
      std::unique_ptr<Simulation> other;
      if (!is_own(n) || evened_) {
        other = compile_grid(n);
        if (!other && stop_.empty()) continue;  // too coarse for the section: the next one may do
        if (!other) break;
        co_yield Pause{};
      }
      Simulation& simulation = other ? *other : simulation_;
      const std::shared_ptr<SavedState> before = other ? nullptr : simulation.save();
      if (!other) simulation.start_over();  // as the other grids do, whatever the soil has been through
      progress_.level = static_cast<int>(n);
      progress_.srf_stable = progress_.srf_unstable = kNone;
      const std::int64_t steps = progress_.steps;
      const std::size_t trials = result_.trials.size();
      GridSearch search(simulation, search_options(simulation), static_cast<int>(n), result_.trials, progress_);
      for (Slices s = search.run(); !out_of_time() && s.next(); co_yield Pause{}) estimate_fraction(n);
      const bool whole = !out_of_time();
      const bool bracketed = whole && search.end() == SearchEnd::kBracketed;
      if (!other && (!whole || search.end() == SearchEnd::kDiverged)) simulation.restore(*before);
      else if (!bracketed) simulation.halt();
      Level level = level_of(simulation, search);
      if (bracketed) {
        level.factor_of_safety = (search.stable() + search.failed()) / 2;
        result_.displacement_level = search.displacement_level();
        for (Slices s = mechanism(simulation, search.response_steps() / 2); s.next();) co_yield Pause{};
        if (has_friction() && !result_.slip_surface.empty())
          level.sliding_thickness = result_.sliding_area / length_of(result_.slip_surface);
        level.sliding_area = result_.sliding_area, level.energy_residual = result_.energy_residual;
        if (is_own(n) && other) simulation_.take_stresses(*other);
      }
      level.steps = progress_.steps - steps;
      level.trials = static_cast<std::int64_t>(result_.trials.size() - trials);
      co_yield Pause{};  // brings the clocks up to date
      level.wall_seconds = result_.wall_seconds - wall, level.cpu_seconds = result_.cpu_seconds - cpu;
      result_.levels.push_back(level);
      if (bracketed) {
        take_stock();
        continue;
      }
      if (!whole) {
        stop_ = "the budget ended within grid " + std::to_string(n + 1);
        break;
      }
      give_up(search);
      if (n == 0 && open_) continue;  // too coarse to tell anything: the next grid may
      gave_up_ = true;
      break;
    }
    conclude();
  }

  void check_options() const override {
    const double low = option("srf_min"), high = option("srf_max");
    if (low < high) return;
    Issue issue;
    issue.status = Status::kRange, issue.object = ObjectKind::kJob, issue.value = high;
    issue.text = "srf_max = " + number_text(high) + ": must be greater than srf_min = " + number_text(low);
    throw Error(issue);
  }

  // ---- which grids ----

  void plan() {
    target_ = option("target_error"), budget_ = option("budget");
    contrast_ = stiffness_contrast(simulation_), scene_ = with_contrast(simulation_, option("stiffness_contrast"));
    evened_ = contrast_.ratio > option("stiffness_contrast");
    const int levels = static_cast<int>(option("levels"));
    open_ = levels == 0 && (target_ > 0 || budget_ > 0);
    if (!open_) closed_ = closed_ladder(levels == 0 ? 2 : levels);
    most_ = open_ ? kOpenLadder : closed_.size();
    const SceneDef& scene = simulation_.scene();
    facts_.support = 2 * scene.smoothing_ratio, facts_.height = simulation_.get("height");
    facts_.cut_off = any_yielding_soil(simulation_, [](const MaterialDef& m) { return !std::isnan(m.tension_cutoff); });
    const std::vector<Real> thickness = material_thickness(scene, scene.spacing, simulation_.layers());
    if (std::count_if(thickness.begin(), thickness.end(), [](Real t) { return !std::isnan(t); }) < 2) return;
    for (std::size_t m = 0; m < thickness.size(); ++m)
      if (!(thickness[m] >= facts_.thinnest.thickness) && !std::isnan(thickness[m]))
        facts_.thinnest = {scene.materials[m].name, thickness[m]};
  }

  Grid grid(std::size_t n) const { return open_ ? open_ladder(static_cast<int>(n)) : closed_[n]; }
  /// The grid the simulation was compiled with: that of the scene's spacing.
  bool is_own(std::size_t n) const { return open_ ? n == 1 : n + 1 == most_; }

  bool out_of_time() const { return budget_ > 0 && result_.wall_seconds > budget_; }

  /// Whether grid n is wanted and the budget can hold it.
  bool goes_on(std::size_t n) {
    if (whole().empty()) return true;
    predict(n);
    if (target_ > 0 && met()) {
      stop_ = "the target of " + number_text(target_) + " is met";
      return false;
    }
    const double left = budget_ - result_.wall_seconds;
    if (budget_ > 0 && result_.next_level_seconds > left) {
      stop_ = "the next grid would take about " + number_text(result_.next_level_seconds, 2) + " s, more than the " +
              number_text(std::max(left, 0.0), 2) + " s left of the budget";
      return false;
    }
    return true;
  }

  void predict(std::size_t n) {
    const Grid next = n < most_ ? grid(n) : open_ladder(2);
    const SceneDef& scene = simulation_.scene();
    result_.next_level_spacing = scene.spacing * next.spacing_factor * next.coarsening;
    result_.next_level_seconds = predicted_seconds(whole(), result_.next_level_spacing);
  }

  /// Nothing when it would need more particles than allowed, or when its cells are too large for the section.
  std::unique_ptr<Simulation> compile_grid(std::size_t n) {
    CompileOptions options = simulation_.options();
    if (is_own(n)) {
      options.log = nullptr;  // which has been told of this grid
    } else {
      const Grid g = grid(n);
      options.spacing_factor = g.spacing_factor, options.lattice_multiple = g.multiple;
      options.coarsening = g.coarsening;
    }
    try {
      std::unique_ptr<Simulation> made = Simulation::compile(scene_, options);
      take_over(simulation_, *made);
      return made;
    } catch (const Error& error) {
      if (!is_own(n) && error.issue().status == Status::kRange) {
        left_out_ = error.issue().text;
        return nullptr;
      }
      if (!open_ || error.issue().status != Status::kLimit) throw;
      stop_ = error.issue().text;
      return nullptr;
    }
  }

  /// Of a bracket. Half of the target is left to the brackets of the two grids that are extrapolated.
  double tolerance() const {
    constexpr double kNarrowest = 1e-4;
    const double asked = option("srf_tolerance");
    return target_ > 0 ? std::clamp(target_ / 3, kNarrowest, asked) : asked;
  }

  SearchOptions search_options(const Simulation& simulation) const {
    SearchOptions options;
    options.srf_min = option("srf_min"), options.srf_max = option("srf_max");
    options.tolerance = tolerance();
    options.careful = option("careful") != 0;
    options.step_limit = static_cast<std::int64_t>(option("step_limit"));
    if (const std::vector<Level> levels = whole(); !levels.empty()) {
      const Level& last = levels.back();
      const double spacing = std::sqrt(simulation.get("spacing_x") * simulation.get("spacing_y"));
      options.guess = last.estimate + (last.factor_of_safety - last.estimate) * spacing / spacing_of(last);
    }
    return options;
  }

  // ---- what came out ----

  static Level level_of(const Simulation& simulation, const GridSearch& search) {
    Level level;
    level.spacing_x = simulation.get("spacing_x"), level.spacing_y = simulation.get("spacing_y");
    level.particles = simulation.particle_count(), level.bonds = simulation.bond_count();
    level.misfit = simulation.section().lattice.misfit.maxCoeff();
    level.srf_stable = search.stable(), level.srf_unstable = search.failed();
    level.unsteadiness = search.unsteadiness(), level.hardening = search.hardening();
    return level;
  }

  /// The levels with a bracket.
  std::vector<Level> whole() const {
    std::vector<Level> levels;
    for (const Level& l : result_.levels)
      if (!std::isnan(l.factor_of_safety)) levels.push_back(l);
    return levels;
  }

  /// After a level with a bracket.
  void take_stock() {
    now_ = estimate(whole(), facts_);
    Level& last = result_.levels.back();
    last.estimate = now_.value, last.error_estimate = now_.error;
    result_.srf_stable = last.srf_stable, result_.srf_unstable = last.srf_unstable;
  }

  /// A skin stays one on the finest grid: its estimate counts like that of an extrapolated value.
  bool met() const {
    return (now_.status == "OK" || now_.status == "THIN_SLIDE") && now_.discretisation && now_.error <= target_;
  }

  bool has_friction() const {
    return any_yielding_soil(simulation_, [](const MaterialDef& m) { return m.friction_angle > 0; });
  }

  /// A mechanism that comes out at the end of the section would go on beyond it, and at a lower factor.
  std::string cut_off_at_a_side() const {
    constexpr Real kNear = 2, kUpright = 3;  // spacings: from a side; what a side is high that could cut it off
    const Level& finest = result_.levels.back();
    const std::vector<Point>& line = result_.slip_surface;
    std::string text;
    if (line.empty()) return text;
    for (const SectionEnd& end : upright_ends(simulation_.section().exterior, kUpright * finest.spacing_y)) {
      const auto ends_here = [&](const Point& p) { return std::fabs(p.x - end.x) < kNear * finest.spacing_x; };
      if (ends_here(line.front()) || ends_here(line.back()))
        text += std::string("; the slip surface comes out at the ") + end.name +
                " end of the section, x = " + number_text(end.x) + " m: a longer section may fail at a lower factor";
    }
    return text;
  }

  /// Soil that cracks where it hangs in tension leaves less to hold the slope.
  std::string held_by_tension() const {
    constexpr Real kDeep = 0.15;  // of the height; below, soil without tension is at most 2 % less stable
    if (!(tension_depth_ > kDeep * facts_.height)) return {};
    return "; the failing soil hangs in tension (effective stress) down to " + number_text(tension_depth_, 2) +
           " m below the ground: should it crack, the slope fails at a lower factor";
  }

  /// Soils whose cohesion was counted as the least that a grid of that spacing can have (least_cohesion).
  std::string raised_cohesion(double spacing) const {
    std::string text;
    for (const std::size_t soil : yielding_soils(simulation_)) {
      const MaterialDef& m = simulation_.scene().materials[soil];
      const double least = least_cohesion(m, spacing);
      if ((std::isnan(m.cohesion) ? 0 : m.cohesion) < least)
        text += "; '" + m.name + "' counted with a cohesion of " +
                quantity_text(least, "Pa", simulation_.scene().units, 3) +
                ", 3 % of the weight of one layer of particles";
    }
    return text;
  }

  /// Grids that were asked for and could not be bracketed leave no answer; those that were only wished for leave that
  /// of the grids before.
  void conclude() {
    const std::vector<Level> levels = whole();
    if (levels.empty() && !stop_.empty()) {
      result_.status = "NOT_CONVERGED", result_.reason = stop_, outcome_ = Status::kNotConverged;
      return;
    }
    if (levels.empty() || (gave_up_ && !open_)) {  // give_up has said why
      result_.next_level_spacing = result_.next_level_seconds = kNone;
      return;
    }
    if (gave_up_) stop_ = "the next grid: " + result_.reason;
    if (!gave_up_ && stop_.empty()) predict(most_);
    result_.srf_stable = levels.back().srf_stable, result_.srf_unstable = levels.back().srf_unstable;
    outcome_ = Status::kOk;
    result_.factor_of_safety = now_.value;
    result_.error_estimate = levels.size() > 1 ? now_.error : kNone;  // half a bracket is no error of the grid
    result_.observed_order = now_.observed_order;
    result_.status = now_.status, result_.reason = now_.reason;
    if (now_.status == "ENERGY_UNBALANCED") outcome_ = Status::kNotConverged;
    if (!stop_.empty()) result_.reason += "; " + stop_;
    if (!left_out_.empty()) result_.reason += "; a coarser grid is left out (" + left_out_ + ")";
    if (result_.srf_unstable - result_.srf_stable > tolerance() * (1 + 1e-9))
      result_.reason += "; inside the bracket neither equilibrium nor steady failure showed: it is wider than " +
                        number_text(tolerance(), 3);
    constexpr double kWide = 0.1, kUseless = 0.2;
    const double share = result_.error_estimate / result_.factor_of_safety;
    if (levels.size() > 1 && share > kWide)
      result_.reason += "; the estimate is " + number_text(std::round(100 * share)) +
                        " % of the value: " + (share > kUseless ? "too coarse to judge the slope by, " : "") +
                        "use a finer spacing";
    result_.reason += raised_cohesion(std::sqrt(levels.back().spacing_x * levels.back().spacing_y));
    result_.reason += cut_off_at_a_side();
    result_.reason += held_by_tension();
    if (side_of_slide_ != 0)
      result_.reason +=
          std::string("; the soil slides to both sides at once, and the slip surface is that of the slide to the ") +
          (side_of_slide_ < 0 ? "left" : "right");
    if (evened_)
      result_.reason += "; '" + contrast_.stiffest + "' counted as " + number_text(option("stiffness_contrast")) +
                        " times as stiff as '" + contrast_.softest + "', not " + number_text(contrast_.ratio) +
                        " times: the factor of safety does not depend on it";
    if (!(target_ > 0) || met()) return;
    outcome_ = Status::kNotConverged;
    result_.reason += "; the target of " + number_text(target_) + " is not met";
    if (result_.status == "OK") result_.status = "TARGET_NOT_MET";
  }

  void estimate_fraction(std::size_t n) {
    // a grid costs about spacing^-3; inside a grid the phases are of like length
    const auto cost = [&](std::size_t k) { return std::pow(grid(k).spacing_factor * grid(k).coarsening, -3); };
    double before = 0, all = 0;
    for (std::size_t k = 0; k < (open_ ? n + 1 : most_); ++k) (k < n ? before : all) += cost(k);
    static constexpr double kPhase[] = {0, 0.05, 0.3, 0.6, 0.8, 0.95};
    double fraction = (before + cost(n) * kPhase[static_cast<int>(progress_.phase)]) / (before + all);
    if (budget_ > 0) fraction = std::max(open_ ? 0 : fraction, result_.wall_seconds / budget_);
    progress_.fraction = std::clamp(fraction, progress_.fraction, 1.0);
  }

  void describe() {
    const SceneDef& scene = simulation_.scene();
    result_.scheme = scene.bond == "none"
                         ? "corrected nodal SPH, no bonds"
                         : "VB-GPD: selective virtual bonds, reconstructed from the published introduction";
    bool cutoff = false, dilates = false, associated = true;
    for (const MaterialDef& m : scene.materials) {
      cutoff |= !std::isnan(m.tension_cutoff) && m.tension_cutoff > 0;
      dilates |= m.dilatancy_angle > 0;
      associated &= m.dilatancy_angle == m.friction_angle;
    }
    result_.reduced = cutoff ? "cohesion, tan(friction angle), tension cut-off" : "cohesion, tan(friction angle)";
    result_.flow_rule = associated ? "associated (dilatancy angle = friction angle)"
                                   : (dilates ? "non-associated, dilatancy angle limited by the reduced friction angle"
                                              : "non-associated, dilatancy angle 0");
  }

  /// Lets the failing slope flow for half a response time more and reads the mechanism and the energy balance off it.
  Slices mechanism(Simulation& simulation, std::int64_t response) {
    progress_.phase = Phase::kSlipSurface;
    const Instant before = instant(simulation);
    const Real elastic_before = simulation.elastic_energy();
    RelaxOptions options;
    options.ledger = true;
    // a step books the work around its beginning and the plastic work of the step before: half of the first and of
    // one step beyond the last, and the plastic work from the second on, belong to this motion
    Real internal = 0, plastic = 0;
    const auto march = [&](std::int64_t steps, Real share) {
      const RelaxReport r = simulation.relax(steps, options);
      progress_.steps += r.steps;
      internal -= share * r.internal_work;
      return r.plastic_work;
    };
    march(1, 0.5);
    for (std::int64_t n = 0; n < response; n += 10, co_yield Pause{}) plastic += march(10, 1);
    const Real stored = simulation.elastic_energy() - elastic_before;
    plastic += march(1, 0.5);
    const Real largest = std::max({std::fabs(internal), std::fabs(stored), std::fabs(plastic)});
    result_.energy_residual = largest > 0 ? std::fabs(internal - stored - plastic) / largest : 0;
    const SlipSurface slip = slip_surface(simulation, before, instant(simulation));
    result_.slip_surface = slip.line;
    result_.sliding_area = slip.sliding_area;
    side_of_slide_ = slip.side;
    tension_depth_ = tension_depth(simulation);
    result_.max_displacement = simulation.get("max_displacement");
    simulation.halt();  // velocities of the relaxation are none of the soil
  }

  void give_up(const GridSearch& search) {
    result_.srf_stable = search.stable(), result_.srf_unstable = search.failed();
    result_.reason = search.reason();
    switch (search.end()) {
      case SearchEnd::kBelowMin:
        result_.status = "BELOW_MIN", outcome_ = Status::kNotConverged;
        if (const std::vector<Level> before = whole(); !before.empty()) {
          result_.status = "NOT_CONVERGED";
          result_.reason = "the finest grid so far fails even at " + number_text(option("srf_min")) +
                           ", where a coarser one stands at " + number_text(before.back().srf_stable) +
                           ": no factor of safety can be told (soil that bears no tension may come apart column by "
                           "column; another spacing may do)";
        }
        break;
      case SearchEnd::kAboveMax:
        result_.status = "ABOVE_MAX", outcome_ = Status::kNotConverged;
        break;
      case SearchEnd::kDiverged:
        result_.status = "DIVERGED", outcome_ = Status::kDiverged;
        break;
      default:
        result_.status = "NOT_CONVERGED", outcome_ = Status::kNotConverged;
        if (dilates()) result_.reason += "; soil that dilates may do so on a finer grid, or with dilatancy_angle 0";
    }
  }

  bool dilates() const {
    return any_yielding_soil(simulation_, [](const MaterialDef& m) { return m.dilatancy_angle > 0; });
  }

  double target_ = 0, budget_ = 0;
  bool open_ = false;
  std::vector<Grid> closed_;
  std::size_t most_ = 0;
  SectionFacts facts_;
  StiffnessContrast contrast_;
  Real tension_depth_ = 0;  // on the finest grid, m
  int side_of_slide_ = 0;   // on the finest grid; SlipSurface::side
  bool evened_ = false;     // stiffer soil counts as less stiff than it is
  SceneDef scene_;          // with that
  Estimate now_;            // of the grids so far
  bool gave_up_ = false;
  std::string stop_;      // why no further grid was begun or ended
  std::string left_out_;  // why a coarse grid was passed over
};

}  // namespace

std::unique_ptr<Job> make_strength_reduction(Simulation& simulation) {
  require_fixed_bonds(simulation, "strength reduction");
  const std::string& bond = simulation.scene().bond;
  if (bond != "virtual_bond" && bond != "none")
    throw Error(Status::kUnsupported, "strength reduction is not offered with bond \"" + bond +
                                          "\": it exists to be compared with in a run-out; use virtual_bond or none");
  return std::make_unique<StrengthReductionJob>(simulation);
}

}  // namespace vbgpd
