// Equilibrium under weight, seismic force and loads with the strengths at hand.
#include "analysis/slice_job.h"

namespace vbgpd {

namespace {

class EquilibriumJob final : public SliceJob {
 public:
  using SliceJob::SliceJob;

 private:
  Slices analysis() override {
    progress_.phase = Phase::kGravity;
    const double factor = simulation_.get("strength_reduction_factor");
    const auto start = simulation_.save();
    // the elastic response first: it sets the time scale of the verdict
    RelaxOptions elastic;
    elastic.elastic = true;
    std::int64_t response = 0;
    double elastic_displacement = 0;
    constexpr std::int64_t kMost = 200000;
    for (RelaxReport r; response < kMost; co_yield Pause{}) {
      r = simulation_.relax(10, elastic);
      response += r.steps, progress_.steps += r.steps, elastic_displacement = r.max_displacement;
      if (r.unbalanced_force_ratio < 1e-6 || r.diverged) break;
    }
    simulation_.restore(*start);
    Trial trial;
    trial.strength_reduction_factor = progress_.strength_reduction_factor = factor;
    TrialRules rules;
    rules.equilibrium = 1e-6;
    rules.step_limit = static_cast<std::int64_t>(option("step_limit"));
    TrialRun run(simulation_, rules, std::max<std::int64_t>(40, response), elastic_displacement);
    for (Slices s = run.run(trial, progress_); s.next();) co_yield Pause{};
    if (run.diverged()) simulation_.restore(*start);
    else simulation_.halt();
    result_.trials.push_back(trial);
    result_.unbalanced_force_ratio = trial.unbalanced_force_ratio;
    result_.max_displacement = progress_.max_displacement;
    result_.displacement_level = trial.displacement_level;
    finish(trial, run.diverged());
  }

  void finish(const Trial& trial, bool diverged) {
    if (diverged) {
      outcome_ = Status::kDiverged, result_.status = "DIVERGED", result_.reason = "displacements ran away";
    } else if (trial.verdict == Verdict::kStable) {
      outcome_ = Status::kOk, result_.status = "STABLE", result_.reason = "the unbalanced force ratio fell below 1e-6";
    } else if (trial.verdict == Verdict::kFailed) {
      outcome_ = Status::kUnstable, result_.status = "UNSTABLE";
      result_.reason = "the unbalanced force stays on a plateau, displacements grow, and a connected band yields";
    } else {
      outcome_ = Status::kNotConverged, result_.status = "NOT_CONVERGED";
      result_.reason = "neither equilibrium nor steady failure showed within the step limit";
    }
  }
};

}  // namespace

std::unique_ptr<Job> make_equilibrium(Simulation& simulation) {
  require_fixed_bonds(simulation, "equilibrium");
  return std::make_unique<EquilibriumJob>(simulation);
}

}  // namespace vbgpd
