// Steps of a run-out: so many, to an exact time, or damped ones before the release.
#include <algorithm>
#include <cmath>

#include "simulation/flow_simulation.h"
#include "simulation/march.h"

namespace vbgpd {

StepReport FlowSimulation::march(const Goal& goal, const StepWatch& watch) {
  StepReport report;
  const Workers::Session session(workers_);
  FlowControls c = controls();
  if (room_ < 0) refresh_neighbours(0);  // memory ran out before the lists of the last step could be looked at
  open_ledger();
  // A particle that crosses a spacing in a step has left the method; the state of at most kKeep steps before is good.
  constexpr std::int64_t kKeep = 256;
  const Real longest = model_.time_step, runaway = model_.spacing / longest;
  std::shared_ptr<SavedState> kept = save();
  std::int64_t kept_at = 0;
  while (report.steps < goal.steps && time_ < goal.time) {
    report.status = watch();
    if (report.status != Status::kOk) break;
    const StepLength length = step_towards(goal.time, time_, longest);
    c.time_step = length.time_step;
    if (report.steps - kept_at >= kKeep) kept = save(), kept_at = report.steps;
    FlowSums sums;
    run_step(c, sums);
    if (!(sums.velocity2 < runaway * runaway) || !std::isfinite(sums.unbalanced)) {
      restore(*kept);
      report.steps = kept_at;
      report.status = Status::kDiverged, report.cause = kOutranWaves;
      return report;
    }
    report.speed_share = std::max(report.speed_share, std::sqrt(sums.velocity2) / runaway);
    ledger_.external += sums.external, ledger_.internal += sums.internal, ledger_.bond += sums.bond;
    ledger_.viscous += sums.viscous, ledger_.damping += sums.damping, ledger_.contact += sums.contact - sums.wall;
    peak_kinetic_ = std::max(peak_kinetic_, sums.kinetic);
    ++steps_, ++report.steps;
    time_ = length.last ? goal.time : time_ + c.time_step;
    refresh_neighbours(c.time_step);
  }
  note_farthest();
  return report;
}

RelaxReport FlowSimulation::relax(std::int64_t steps, const RelaxOptions& options) {
  const Workers::Session session(workers_);
  FlowControls c = controls();
  c.local_damping = options.local_damping > 0 ? options.local_damping : 0.7;
  c.time_step *= options.time_step_factor;
  if (options.elastic) c.laws = elastic_laws_.data(), c.walls_hold = 1;
  RelaxReport r;
  FlowSums sums;
  const Real runaway = model_.spacing / c.time_step;
  for (std::int64_t n = 0; n < steps && !r.diverged; ++n) {
    run_step(c, sums);
    ++r.steps;
    r.external_work += sums.external, r.internal_work -= sums.internal + sums.bond;
    r.diverged = !(sums.velocity2 < runaway * runaway) || !std::isfinite(sums.unbalanced);
    refresh_neighbours(c.time_step);
  }
  r.since_restart = r.steps;
  r.unbalanced_force_ratio = model_.force_scale > 0 ? sums.unbalanced / model_.force_scale : 0;
  r.velocity = std::sqrt(sums.velocity2);
  r.max_displacement = max_displacement();
  return r;
}

}  // namespace vbgpd
