// The factor of safety on one grid: a bracket whose lower end stands and whose upper end fails, both shown.
#pragma once

#include <memory>
#include <set>

#include "analysis/trial.h"

namespace vbgpd {

struct SearchOptions {
  double srf_min = 0.1, srf_max = 20, tolerance = 0.005;
  double guess = kNone;  ///< from a coarser grid, NaN = none
  bool careful = false;  ///< plain bisection, every trial from the gravity state
  std::int64_t step_limit = 0;
};

enum class SearchEnd { kBracketed, kBelowMin, kAboveMax, kNotConverged, kNoGravity, kDiverged };

class GridSearch {
 public:
  GridSearch(Simulation& simulation, const SearchOptions& options, int level_number, std::vector<Trial>& trials,
             Progress& progress)
      : simulation_(simulation), options_(options), trials_(trials), progress_(progress), level_(level_number) {}

  /// Gravity, search, then trials until the bracket is as narrow as asked. Once bracketed, the simulation is left
  /// failing at the upper end.
  Slices run();

  SearchEnd end() const { return end_; }
  const std::string& reason() const { return reason_; }
  double stable() const { return stable_; }
  double failed() const { return failure_.factor; }
  /// Of the flow at the failed end; its hardening, where it kept its strength, as the first flow showed it.
  double displacement_level() const { return failure_.displacement_level; }
  double unsteadiness() const { return failure_.unsteadiness; }
  double hardening() const { return failure_.hardening; }
  std::int64_t response_steps() const { return response_; }

 private:
  Slices gravity();
  Slices follow();
  struct Overshoot;
  Slices overshoot(double& factor);
  void take_flow(const Overshoot& run, double flow, double fresh);
  Slices come_down(double& factor);
  Slices fast_bracket();
  Slices lower_end();
  Slices upper_end();
  Slices halve();
  Slices upper_end_from_gravity();
  Slices bisection();
  Slices try_factor(double factor, Phase phase);
  void set_factor(double factor);
  double notched(double factor) const;
  double middle() const;
  void stand(double factor, std::int64_t steps, double seconds, const RelaxReport& r);
  void end_below();
  void end_above();
  void set_aside(const Trial& trial);
  void run_away(double factor);
  bool closed() const;

  Simulation& simulation_;
  SearchOptions options_;
  std::vector<Trial>& trials_;
  Progress& progress_;
  int level_;
  std::shared_ptr<SavedState> gravity_, standing_;
  std::int64_t response_ = 0;
  double elastic_displacement_ = 0, stable_ = kNone, flow_ = kNone;
  double fresh_flow_ = kNone;          // F_e over the look at which it was first read
  double followed_flow_ = kNone;       // ... as the flow was followed down
  double first_failing_flow_ = kNone;  // ... of the first trial below that failed
  double flow_hardening_ = 0;          // ... and its rise while the slope would have moved as far again
  struct Failure {                     // the failed end
    double factor = kNone;             // NaN = none yet
    double flow = kNone;               // F_e
    double displacement_level = kNone, unsteadiness = 0, hardening = 0;
    std::shared_ptr<SavedState> state;
  } failure_;
  double runaway_ = kNone;  // lowest factor at which displacements ran away
  Verdict verdict_ = Verdict::kUndecided;
  std::size_t aside_ = 0;  // undecided trials since the last verdict
  SearchEnd end_ = SearchEnd::kNotConverged;
  std::string reason_;
  int longest_ = TrialRules{}.patience;  // response times a trial may take
  int patience_ = longest_;              // ... and the next one
  double undecided_ = 0;                 // trials without a verdict, by the share of the longest one they took
  std::set<double> balanced_;            // factors of those that took the longest
  int runaways_ = 0;
  bool gathers_force_ = false;  // the last failed trial did on its way
  bool done_ = false;
};

}  // namespace vbgpd
