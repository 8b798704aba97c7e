// One strength reduction factor: does the slope stand, does it fail, or can it not be told?
#pragma once

#include <optional>
#include <vector>

#include "analysis/job.h"
#include "analysis/mechanism.h"
#include "analysis/slices.h"

namespace vbgpd {

/// Thresholds of a verdict. Ratios of forces, steps and displacements only: nothing has a dimension.
struct TrialRules {
  double equilibrium = 1e-5;    ///< stable: unbalanced force ratio below this ...
  int equilibrium_windows = 5;  ///< ... in so many windows of ten steps on end
  double plateau_slope = -0.1;  ///< failed: ln R fell by less than this over a response time ...
  double plateau_level = 3;     ///< ... and R stays above so many times `equilibrium`
  double growth =
      0.02;  ///< failed: u_max grew by this share of its elastic value over a response time, not slower than before
  double drive = 0;             ///< failed: F_e = F (internal power / external power) lies below F by this share of it
  double catching_up = 8;       ///< ... and would not have risen to it in so many response times at its present rate
  int long_look = 12;           ///< response times over which the same growth tells a slow flow from creep to rest
  int patience = 30;            ///< undecided after so many response times, or ...
  std::int64_t step_limit = 0;  ///< ... after so many steps, if any
};

/// Runs a simulation at its present strength reduction factor from its present state.
class TrialRun {
 public:
  TrialRun(Simulation& simulation, const TrialRules& rules, std::int64_t response_steps, double elastic_displacement)
      : simulation_(simulation), rules_(rules), response_(response_steps), elastic_(elastic_displacement) {}

  /// Relaxes until a verdict; `trial` and `progress` are kept up to date. The state is left where the verdict fell.
  Slices run(Trial& trial, Progress& progress);
  bool diverged() const { return diverged_; }

 private:
  struct Window {
    std::int64_t steps;
    double ratio, displacement, power_ratio;
  };
  /// Over how many response times a flow is looked at, what it has to grow by meanwhile, and how many response times it
  /// has to catch up with the factor tried.
  struct Look {
    int times;
    double growth, catching_up;
  };
  /// What a look shows: change of ln R, growth of the displacement over its elastic value, RMS by which the power ratio
  /// strays, and whether that is failure.
  struct Flow {
    double slope = 0, growth = 0, unsteadiness = 0;
    bool fails = false;
  };
  bool failing(const std::vector<Window>& history, const RelaxReport& last, Trial& trial) const;
  std::optional<Flow> look(const std::vector<Window>& history, const Look& look) const;
  Simulation& simulation_;
  TrialRules rules_;
  std::int64_t response_;
  double elastic_;
  bool diverged_ = false;
};

/// Wall and CPU seconds since it was made.
class Stopwatch {
 public:
  Stopwatch();
  double wall() const;
  double cpu() const;

 private:
  double wall_, cpu_;
};

}  // namespace vbgpd
