#include "analysis/trial.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <optional>

namespace vbgpd {

namespace {

double wall_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr std::int64_t kWindow = 10;  // steps between two looks

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
  std::optional<Flow> flow = look(history, {times, times * rules_.growth, rules_.catching_up});
  if (!flow || !flow->fails) {
    const auto slow = look(history, {many, rules_.growth, std::max(rules_.catching_up, 2.0 * many)});
    if (slow && slow->fails) flow = slow;
  }
  if (!flow) return false;
  trial.unbalanced_force_slope = flow->slope, trial.displacement_growth = flow->growth;
  trial.unsteadiness = trial.strength_reduction_factor * flow->unsteadiness;
  return flow->fails && last.power_ratio < 1 - rules_.drive;
}

/// None before there is so much to look at. A flow that would balance at the very factor tried, or is hardening towards
/// that, is creep on the way to rest, not failure.
std::optional<TrialRun::Flow> TrialRun::look(const std::vector<Window>& history, const Look& look) const {
  const auto span = static_cast<std::size_t>(2 * look.times * std::max<std::int64_t>(2, response_ / (2 * kWindow)));
  if (history.size() <= span) return std::nullopt;
  const Window &now = history.back(), &half = history[history.size() - 1 - span / 2],
               &then = history[history.size() - 1 - span];
  // means of the earlier and of the later half: a flow trembles
  const auto mean = [&](std::size_t from, std::size_t to, double Window::*what) {
    double sum = 0;
    for (std::size_t k = history.size() - from; k < history.size() - to; ++k) sum += history[k].*what;
    return sum / static_cast<double>(from - to);
  };
  const double earlier = mean(span, span / 2, &Window::ratio), later = mean(span / 2, 0, &Window::ratio);
  const double power = mean(span / 2, 0, &Window::power_ratio),
               hardening = 2 * (power - mean(span, span / 2, &Window::power_ratio)) / look.times;
  // F_e of a jerky flow strays: RMS about the line through its two means
  double squares = 0;
  for (std::size_t k = 0; k < span; ++k) {
    const double line =
        power + (hardening * look.times / 2) * (0.5 - 2 * static_cast<double>(k) / static_cast<double>(span));
    squares += std::pow(history[history.size() - 1 - k].power_ratio - line, 2);
  }
  Flow flow;
  flow.slope = earlier > 0 && later > 0 ? 2 * std::log(later / earlier) : 0;
  flow.growth = elastic_ > 0 ? (now.displacement - then.displacement) / elastic_ : 0;
  flow.unsteadiness = std::sqrt(squares / static_cast<double>(span));
  const bool plateau = flow.slope > rules_.plateau_slope && now.ratio > rules_.plateau_level * rules_.equilibrium;
  const bool grows =
      flow.growth > look.growth && now.displacement - half.displacement >= half.displacement - then.displacement;
  flow.fails = plateau && grows && power + look.catching_up * hardening < 1;
  return flow;
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
    history.push_back({trial.steps, r.unbalanced_force_ratio, r.max_displacement, r.power_ratio});
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
      trial.unbalanced_force_slope = trial.displacement_growth = trial.unsteadiness = 0;
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
    if (trial.steps >= limit) co_return;  // undecided: a step limit is never a verdict
    co_yield Pause{};
  }
}

}  // namespace vbgpd
