// Long analyses in wall-clock slices. A job drives a Simulation from outside and can be stopped between any two steps.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/simulation.h"

namespace vbgpd {

enum class Phase : int { kGravity = 1, kSearch = 2, kStableEnd = 3, kFailedEnd = 4, kSlipSurface = 5, kRunout = 6 };

struct Progress {
  int level = 0, trial = 0;
  Phase phase = Phase::kGravity;
  std::int64_t steps = 0;
  double fraction = 0;
  double strength_reduction_factor = 1;
  double srf_stable = kNone, srf_unstable = kNone;
  double unbalanced_force_ratio = 0, max_displacement = 0;
};

enum class Verdict : int { kUndecided = 0, kStable = 1, kFailed = 2 };

/// One strength reduction factor that was tried, with its evidence (three signals together: core/README.md, "Strength
/// reduction").
struct Trial {
  int level = 0;
  Verdict verdict = Verdict::kUndecided;
  bool band_connected = false;
  double strength_reduction_factor = 1;
  double unbalanced_force_ratio = 0, unbalanced_force_slope = 0;
  double displacement_level = 0, displacement_growth = 0;
  double power_ratio = kNone;  ///< F_e = F (internal power / external power); none at rest
  double unsteadiness = 0;     ///< how far F_e strayed from steady while the failure showed (RMS about a line)
  double hardening = 0;        ///< by how much F_e would rise while the slope moves as far again
  std::int64_t steps = 0;
  double wall_seconds = 0;
};

struct Level {
  double spacing_x = 0, spacing_y = 0;
  std::int64_t particles = 0, bonds = 0, steps = 0, trials = 0;
  double srf_stable = kNone, srf_unstable = kNone, factor_of_safety = kNone;
  double wall_seconds = 0, cpu_seconds = 0;
  double estimate = kNone, error_estimate = kNone;  ///< from this grid and the coarser ones
  double sliding_area = kNone;                      ///< of the mechanism on this grid, m2
  double sliding_thickness = kNone;  ///< area over length of the slip line, m; NaN in soil without friction
  double misfit = 0;                 ///< of key lines from cell edges, in coarse cells
  double unsteadiness = 0;           ///< of the flow at the failed end of the bracket
  double hardening = 0;              ///< rise of F_e while the slope moves as far again
  double energy_residual = 0;        ///< of the flow that shows the mechanism
};

struct JobResult {
  std::string status = "NOT_RUN";  ///< OK, AT_REST, TIME_REACHED, STABLE, UNSTABLE, BELOW_MIN, ABOVE_MAX,
                                   ///< NOT_CONVERGED, NOT_FIRST_ORDER, NOT_MONOTONIC, THIN_LAYER, THIN_SLIDE, TOO_COARSE,
                                   ///< ENERGY_UNBALANCED, TARGET_NOT_MET, DIVERGED, REFUSED, NO_MEMORY, INTERNAL
  std::string reason, scheme, reduced, flow_rule;
  double factor_of_safety = kNone, srf_stable = kNone, srf_unstable = kNone, error_estimate = kNone;
  double displacement_level = kNone, sliding_area = kNone, energy_residual = kNone;
  double unbalanced_force_ratio = kNone, max_displacement = kNone;
  double observed_order = kNone;                                  ///< of three grids
  double next_level_spacing = kNone, next_level_seconds = kNone;  ///< of one more grid: m, and the wall time predicted
  // of a run-out (runout_shape.h)
  double crest_settlement = kNone, toe_displacement = kNone, runout_distance = kNone, moved_area = kNone,
         plastic_fraction = kNone;
  std::int64_t steps = 0;
  double wall_seconds = 0, cpu_seconds = 0;  ///< the latter of the whole process, all its threads
  std::vector<Level> levels;
  std::vector<Trial> trials;
  std::vector<Point> slip_surface;  ///< left to right, scene coordinates
};

/// A named number of a job that may be set before its first run.
struct JobOption {
  const char* name;
  const char* unit;
  const char* doc;
  double default_value, min_value, max_value;  ///< default NaN = from the scene
  bool whole = false;                          ///< a count or a choice: no fractions
};
std::span<const JobOption> job_options();
/// Throws Error(kUnknownName) that says which there are. `what`: option, number, text.
[[noreturn]] void unknown_name(const char* what, std::string_view name, std::span<const std::string_view> known);
/// What Job::get answers: options, then results.
std::vector<std::string_view> job_numbers();

class Job {
 public:
  using Callback = std::function<bool(const Progress&)>;  ///< true = go on
  virtual ~Job() = default;
  /// kOk finished; kLimitReached, kCancelled call again; kNotConverged, kUnstable finished with that outcome;
  /// kDiverged. wall_seconds <= 0 = no limit. The callback is called at most about ten times a second.
  virtual Status run(double wall_seconds, const Callback& callback) = 0;
  virtual void cancel() noexcept = 0;                         ///< any thread, signal-safe
  virtual void set(std::string_view name, double value) = 0;  ///< throws Error(kUnknownName | kRange | kState)
  virtual double get(std::string_view name) const = 0;  ///< options and results by name; throws Error(kUnknownName)
  virtual bool started() const = 0;  ///< a run has begun: options are settled
  virtual bool finished() const = 0;
  virtual const Progress& progress() const = 0;
  virtual const JobResult& result() const = 0;
};

/// Relaxes gravity, seismic and surface loads to equilibrium with the scene's strengths.
std::unique_ptr<Job> make_equilibrium(Simulation& simulation);
/// Factor of safety by strength reduction, coarse to fine. Leaves the simulation in the failing state of its own grid,
/// which is the finest one unless "target_error" or "budget" go on to finer ones (or end before it).
std::unique_ptr<Job> make_strength_reduction(Simulation& simulation);
/// Lets a run-out model move until it rests, or to the job's end_time. A model without stress is first brought to
/// equilibrium under gravity without strengths. Throws Error(kState) unless the simulation runs out.
std::unique_ptr<Job> make_runout_job(Simulation& simulation);

}  // namespace vbgpd
