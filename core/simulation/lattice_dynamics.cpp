// Dynamic steps of a lattice simulation: so many, or to an exact time.
#include <algorithm>
#include <cmath>

#include "simulation/lattice_simulation.h"
#include "simulation/march.h"

namespace vbgpd {

StepReport LatticeSimulation::march(const Goal& goal, const StepWatch& watch) {
  StepReport report;
  const Workers::Session session(workers_);
  const Real longest = dynamic_time_step();
  Controls c;
  c.local_damping = damping_;
  c.mass = model_.mass.data();
  c.constants = constants_.data();
  c.dilation_cap = dilation_cap_.data(), c.keeps_gaps = true;
  c.cohesion_scale = 1 / factor_;
  c.ledger = true;
  // A particle that outruns the waves has left the method; the state of at most kKeep steps before is the last good
  // one.
  constexpr std::int64_t kKeep = 64;
  const Real runaway = 4 / (longest * longest) * section_.lattice.spacing.squaredNorm();
  State kept = state_;
  Ledger kept_ledger = ledger_;
  std::int64_t kept_at = 0;
  Real kept_time = time_;
  const std::int64_t steps_before = steps_;
  if (!ledger_.open) ledger_.before = stored_energy() - ledger_.booked(), ledger_.open = true;
  if (!audit_.valid) begin_audit();
  while (report.steps < goal.steps && time_ < goal.time) {
    report.status = watch();
    if (report.status != Status::kOk) return report;
    const StepLength length = step_towards(goal.time, time_, longest);
    c.time_step = c.kick = length.time_step;
    if (report.steps - kept_at >= kKeep)
      kept = state_, kept_ledger = ledger_, kept_at = report.steps, kept_time = time_;
    Sums sums;
    run_step(data(state_, scratch_), c, sums);
    if (!(sums.velocity2 < runaway) || !std::isfinite(sums.unbalanced)) {
      state_ = kept, ledger_ = kept_ledger;
      steps_ -= report.steps - kept_at, time_ = kept_time;
      return {kept_at, Status::kDiverged, {}, report.speed_share, report.energy_share, kOutranWaves};
    }
    ledger_.external += sums.external_work, ledger_.damping -= sums.damping_work, ledger_.plastic += sums.plastic_work;
    ++steps_, ++report.steps;
    time_ = length.last ? goal.time : time_ + c.time_step;
    last_time_step_ = c.time_step;
    report.unbalanced_force_ratio = unbalanced_force_ratio(sums);
    report.speed_share = std::max(report.speed_share, std::sqrt(sums.velocity2 / runaway));
    const Real energy_share = audit();
    if (energy_share > 1)
      return {std::max<std::int64_t>(0, steps_ - steps_before),
              Status::kDiverged,
              {},
              report.speed_share,
              report.energy_share,
              kEnergyFromNothing};
    report.energy_share = std::max(report.energy_share, energy_share);
  }
  return report;
}

}  // namespace vbgpd
