// One strength reduction factor: does the slope stand, does it fail, or can it not be told?
#pragma once

#include <vector>

#include "analysis/flow_look.h"
#include "analysis/job.h"
#include "analysis/mechanism.h"
#include "analysis/slices.h"

namespace vbgpd {

/// Runs a simulation at its present strength reduction factor from its present state.
class TrialRun {
 public:
  TrialRun(Simulation& simulation, const TrialRules& rules, std::int64_t response_steps, double elastic_displacement)
      : simulation_(simulation), rules_(rules), response_(response_steps), elastic_(elastic_displacement) {}

  /// Relaxes until a verdict; `trial` and `progress` are kept up to date. The state is left where the verdict fell.
  Slices run(Trial& trial, Progress& progress);
  bool diverged() const { return diverged_; }

 private:
  bool failing(const std::vector<Window>& history, const RelaxReport& last, Trial& trial) const;

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
