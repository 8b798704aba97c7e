// The factor of safety by strength reduction on one to three grids, extrapolated, with its slip surface.
#include <cmath>

#include "analysis/grid_search.h"
#include "analysis/slice_job.h"
#include "scene/wording.h"

namespace vbgpd {

namespace {

/// First-order extrapolation from spacings 2h and h (accuracy notes): FS* = 2 FS(h) - FS(2h).
double extrapolated(double coarse, double fine) { return 2 * fine - coarse; }

class StrengthReductionJob final : public SliceJob {
 public:
  using SliceJob::SliceJob;

 private:
  struct Grid {
    Real spacing_factor;
    int multiple, coarsening;
  };
  /// Coarse to fine; the last one is the simulation itself.
  static std::vector<Grid> grids(int levels) {
    if (levels == 1) return {{1, 2, 1}};
    if (levels == 2) return {{1, 2, 2}, {1, 2, 1}};
    return {{1, 2, 2}, {std::sqrt(2.0), 1, 1}, {1, 2, 1}};
  }

  Slices analysis() override {
    describe();
    const std::vector<Grid> list = grids(static_cast<int>(option("levels")));
    std::vector<double> factors;
    for (std::size_t n = 0; n < list.size(); ++n) {
      const bool finest = n + 1 == list.size();
      progress_.level = static_cast<int>(n);
      progress_.srf_stable = progress_.srf_unstable = kNone;
      std::unique_ptr<Simulation> coarse;
      const Stopwatch watch;
      if (!finest) coarse = compile_grid(list[n]);
      Simulation& simulation = finest ? simulation_ : *coarse;
      SearchOptions options;
      options.srf_min = option("srf_min"), options.srf_max = option("srf_max"),
      options.tolerance = option("srf_tolerance");
      options.careful = option("careful") != 0;
      options.step_limit = static_cast<std::int64_t>(option("step_limit"));
      if (!factors.empty()) options.guess = factors.back();
      const std::int64_t steps_before = progress_.steps;
      const std::size_t trials_before = result_.trials.size();
      GridSearch search(simulation, options, static_cast<int>(n), result_.trials, progress_);
      for (Slices s = search.run(); s.next(); co_yield Pause{}) estimate_fraction(n, list.size());
      Level level;
      level.spacing_x = simulation.get("spacing_x"), level.spacing_y = simulation.get("spacing_y");
      level.particles = simulation.particle_count(), level.bonds = simulation.bond_count();
      level.steps = progress_.steps - steps_before;
      level.trials = static_cast<std::int64_t>(result_.trials.size() - trials_before);
      level.srf_stable = search.stable(), level.srf_unstable = search.failed();
      if (search.end() == SearchEnd::kBracketed) level.factor_of_safety = (search.stable() + search.failed()) / 2;
      level.wall_seconds = watch.wall(), level.cpu_seconds = watch.cpu();
      result_.levels.push_back(level);
      result_.srf_stable = search.stable(), result_.srf_unstable = search.failed();
      if (search.end() != SearchEnd::kBracketed) {
        give_up(search);
        co_return;
      }
      factors.push_back(level.factor_of_safety);
      if (finest) {
        result_.displacement_level = search.displacement_level();
        for (Slices s = mechanism(search.response_steps()); s.next();) co_yield Pause{};
      }
    }
    conclude(factors);
  }

  std::unique_ptr<Simulation> compile_grid(const Grid& grid) const {
    CompileOptions options = simulation_.options();
    options.spacing_factor = grid.spacing_factor, options.lattice_multiple = grid.multiple,
    options.coarsening = grid.coarsening;
    return Simulation::compile(simulation_.scene(), options);
  }

  void estimate_fraction(std::size_t n, std::size_t count) {
    // a finer grid costs about eight times the coarser one; inside a grid the phases are of like length
    const double share = count == 1 ? 1 : (n + 1 == count ? 0.85 : 0.15 / static_cast<double>(count - 1));
    const double done = n + 1 == count && count > 1
                            ? 0.15
                            : 0.15 * static_cast<double>(n) / std::max(1.0, static_cast<double>(count - 1));
    static constexpr double kPhase[] = {0, 0.05, 0.3, 0.6, 0.8, 0.95};
    progress_.fraction = std::max(progress_.fraction, done + share * kPhase[static_cast<int>(progress_.phase)]);
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

  /// Lets the failing slope flow for one more response time and reads the mechanism and the energy balance off it.
  Slices mechanism(std::int64_t response) {
    progress_.phase = Phase::kSlipSurface;
    const Instant before = instant(simulation_);
    const Real elastic_before = simulation_.elastic_energy();
    RelaxOptions options;
    options.ledger = true;
    Real internal = 0, plastic = 0;
    for (std::int64_t n = 0; n < response; n += 10) {
      const RelaxReport r = simulation_.relax(10, options);
      progress_.steps += r.steps;
      internal -= r.internal_work, plastic += r.plastic_work;
      co_yield Pause{};
    }
    const Real stored = simulation_.elastic_energy() - elastic_before;
    const Real largest = std::max({std::fabs(internal), std::fabs(stored), std::fabs(plastic)});
    result_.energy_residual = largest > 0 ? std::fabs(internal - stored - plastic) / largest : 0;
    const SlipSurface slip = slip_surface(simulation_, before, instant(simulation_));
    result_.slip_surface = slip.line;
    result_.sliding_area = slip.sliding_area;
    result_.max_displacement = simulation_.get("max_displacement");
  }

  void give_up(const GridSearch& search) {
    result_.reason = search.reason();
    switch (search.end()) {
      case SearchEnd::kBelowMin:
        result_.status = "BELOW_MIN", outcome_ = Status::kNotConverged;
        break;
      case SearchEnd::kAboveMax:
        result_.status = "ABOVE_MAX", outcome_ = Status::kNotConverged;
        break;
      case SearchEnd::kDiverged:
        result_.status = "DIVERGED", outcome_ = Status::kDiverged;
        break;
      default:
        result_.status = "NOT_CONVERGED", outcome_ = Status::kNotConverged;
    }
  }

  void conclude(const std::vector<double>& factors) {
    const double fine = factors.back(), half = (result_.srf_unstable - result_.srf_stable) / 2;
    result_.status = "OK";
    result_.factor_of_safety = fine;
    result_.error_estimate = half;
    outcome_ = Status::kOk;
    if (factors.size() == 1) {
      result_.reason = "bracketed on one grid; the discretisation error is not estimated";
      return;
    }
    const double best = extrapolated(factors.front(), fine), difference = std::fabs(best - fine);
    // brackets enter the extrapolated value three half widths deep; half of what was extrapolated stays in doubt
    const double doubt = 3 * half + difference / 2;
    result_.factor_of_safety = best;
    result_.error_estimate = doubt;
    result_.reason = "bracketed on " + std::to_string(factors.size()) + " grids and extrapolated at first order";
    if (factors.size() == 3) check_order(factors, fine, difference, half);
    const Vec2 misfit = simulation_.section().lattice.misfit;
    if (misfit.maxCoeff() > 0.1) {
      result_.error_estimate = std::max(result_.error_estimate, difference + 3 * half);
      result_.reason += "; key lines lie up to " + number_text(misfit.maxCoeff(), 2) +
                        " of a coarse cell off the cell edges, so the estimate is widened";
    }
  }

  /// With spacings 2, sqrt 2 and 1 first order means (FS2 - FS1.41)/(FS1.41 - FS1) = sqrt 2; otherwise no
  /// extrapolation.
  void check_order(const std::vector<double>& factors, double fine, double difference, double half) {
    const double first = factors[0] - factors[1], second = factors[1] - factors[2];
    const double noise = 2 * half;
    const bool small = std::fabs(first) <= 2 * noise && std::fabs(second) <= 2 * noise;
    const double ratio = second != 0 ? first / second : kNone;
    if (small || std::fabs(ratio / std::sqrt(2.0) - 1) <= 0.3) {
      result_.reason += ", the order checked on the grid between";
      return;
    }
    result_.status = "NOT_FIRST_ORDER";
    result_.factor_of_safety = fine;
    result_.error_estimate = difference + 3 * half;
    result_.reason = "the three grids do not differ at first order (ratio " + number_text(ratio, 3) +
                     ", first order is 1.41): the value of the finest grid is given, not extrapolated";
  }
};

}  // namespace

std::unique_ptr<Job> make_strength_reduction(Simulation& simulation) {
  return std::make_unique<StrengthReductionJob>(simulation);
}

}  // namespace vbgpd
