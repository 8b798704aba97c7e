#include "analysis/trial.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <optional>

namespace vbgpd {

namespace {

double wall_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

Stopwatch::Stopwatch() : wall_(wall_now()), cpu_(cpu_now()) {}
double Stopwatch::wall() const { return wall_now() - wall_; }
double Stopwatch::cpu() const { return cpu_now() - cpu_; }

/// The first two signals of a failure: unbalanced force on a plateau, displacement growing and not slowing down. Looked
/// at over one response time, or over three once the momentum had to restart (the forces turned against the motion: the
/// flow is jerky), and over many, where a flow so slow that a brief look cannot tell it from rest shows itself.
bool TrialRun::failing(const std::vector<Window>& history, const RelaxReport& last, Trial& trial) const {
  const bool jerky = last.since_restart < std::min(3 * response_, trial.steps);
  const int times = jerky ? 3 : 1, many = rules_.long_look;
  const bool far = trial.displacement_level > rules_.far;
  const auto seen = [&](const Look& look) { return flow_in(history, look, rules_, response_, elastic_); };
  std::optional<Flow> flow = seen({times, times * rules_.growth, rules_.catching_up, far});
  if (!flow || !flow->fails) {
    const auto slow = seen({many, rules_.growth, std::max(rules_.catching_up, 2.0 * many), far});
    if (slow && slow->fails) flow = slow;
  }
  if (!flow) return false;
  trial.unbalanced_force_slope = flow->slope, trial.displacement_growth = flow->growth;
  trial.unsteadiness = trial.strength_reduction_factor * flow->unsteadiness;
  if (!flow->fails || !(last.power_ratio < 1 - rules_.drive)) return false;
  const auto hardening = hardening_in(history);
  if (!hardening) return false;
  trial.hardening = trial.strength_reduction_factor * hardening->rise;
  const double to_come = far ? 0 : std::max(0.0, hardening->rise);
  return hardening->power_ratio + to_come < 1 - rules_.drive;
}

Slices TrialRun::run(Trial& trial, Progress& progress) {
  const Stopwatch watch;
  const std::int64_t limit = rules_.step_limit > 0 ? rules_.step_limit : rules_.patience * response_;
  const RelaxOptions options;
  const double factor = trial.strength_reduction_factor;
  std::vector<Window> history;
  int at_rest = 0;
  std::optional<Instant> before;
  std::int64_t band_due = 0;
  simulation_.halt();
  for (;;) {
    const RelaxReport r = simulation_.relax(kWindow, options);
    trial.steps += r.steps, progress.steps += r.steps;
    history.push_back({r.unbalanced_force_ratio, r.max_displacement, std::fmax(0, r.external_power), r.power_ratio});
    trial.unbalanced_force_ratio = progress.unbalanced_force_ratio = r.unbalanced_force_ratio;
    progress.max_displacement = r.max_displacement;
    trial.displacement_level = r.max_displacement / simulation_.displacement_scale();
    trial.power_ratio = factor * r.power_ratio;
    trial.wall_seconds = watch.wall();
    if (r.diverged) {
      diverged_ = true;
      co_return;
    }
    at_rest = r.unbalanced_force_ratio < rules_.equilibrium ? at_rest + 1 : 0;
    if (at_rest >= rules_.equilibrium_windows) {
      trial.verdict = Verdict::kStable;
      trial.unbalanced_force_slope = trial.displacement_growth = trial.unsteadiness = trial.hardening = 0;
      trial.power_ratio = kNone;  // nothing flows
      co_return;
    }
    // the third signal is looked at once the first two have held for a quarter of a response time more
    if (!failing(history, r, trial)) before.reset();
    else if (!before)
      before = instant(simulation_), band_due = trial.steps + std::max<std::int64_t>(2 * kWindow, response_ / 4);
    else if (trial.steps >= band_due) {
      trial.band_connected = band_connected(simulation_, *before, instant(simulation_));
      if (trial.band_connected) {
        trial.verdict = Verdict::kFailed;
        co_return;
      }
      before = instant(simulation_), band_due = trial.steps + response_;
    }
    const bool creeps = at_rest == 0 && !before && trial.steps >= 2 * response_ && r.since_restart >= response_ / 2;
    if (creeps && std::fabs(1 - r.power_ratio) < rules_.balanced) co_return;
    if (trial.steps >= limit) co_return;  // undecided: a step limit is never a verdict
    co_yield Pause{};
  }
}

}  // namespace vbgpd
