// The flow above the factor of safety: raised until it flows, read, followed down.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/grid_search.h"

namespace vbgpd {

namespace {

constexpr double kFall = 0.01;  // F_e is past its peak when it falls by more than this

}  // namespace

/// What the factor that is to make the slope flow has shown so far.
struct GridSearch::Overshoot {
  std::int64_t steps = 0, looked = 0;
  double best = 0;                         // F_e, highest at a look
  std::shared_ptr<SavedState> best_state;  // ... and what it was read of
  double unbalanced = 1;                   // force ratio at the look before
  int falls = 0, at_rest = 0;              // looks past the peak, windows in equilibrium
  std::vector<Window> flow;                // with F_e as the power ratio
  Stopwatch watch;

  bool steady(std::size_t windows) const {
    constexpr double kSteady = 1e-3;  // F_e is read once it changes by less than this over a look
    if (flow.size() <= windows) return false;
    const double now = flow.back().power_ratio;
    return std::fabs(now - flow[flow.size() - 1 - windows].power_ratio) < kSteady * now;
  }
  double mean(std::size_t windows) const {
    const auto add = [](double sum, const Window& w) { return sum + w.power_ratio; };
    return std::accumulate(flow.end() - static_cast<std::ptrdiff_t>(windows), flow.end(), 0.0, add) /
           static_cast<double>(windows);
  }
};

/// Overshoot and follow: let the slope flow a little above its factor of safety and read where the flow would just
/// balance,
///   F_e = F (internal power / external power),
/// which tends to the factor of safety whatever F drives the flow.
Slices GridSearch::follow() {
  progress_.phase = Phase::kSearch;
  double factor = std::isnan(options_.guess) ? 1.0 : 1.04 * options_.guess;
  factor = std::clamp(factor, options_.srf_min, options_.srf_max);
  for (Slices s = overshoot(factor); s.next();) co_yield Pause{};
  if (std::isnan(flow_)) co_return;
  for (Slices s = come_down(factor); s.next();) co_yield Pause{};
}

void GridSearch::take_flow(const Overshoot& run, double flow, double fresh) {
  flow_ = flow, fresh_flow_ = fresh;
  if (const auto hardening = hardening_in(run.flow)) flow_hardening_ = hardening->rise;
}

/// Raises F until the slope flows, then waits until F_e is flat and the flow developed; flow_ is what it reads, NaN
/// where nothing can be read and the careful way has to decide.
Slices GridSearch::overshoot(double& factor) {
  constexpr double kLevel = 12;     // displacement level at which the flow is read
  constexpr double kFlowing = 0.5;  // and that at which it is a flow
  constexpr double kBrisk = 1.04;   // share of F_e at which the flow is driven, at least: less takes ages
  constexpr double kStands = 5e-4;  // unbalanced force ratio, halved since the last look, of a slope about to stand
  const std::int64_t look = std::max<std::int64_t>(2 * kWindow, response_ / 2), most = 60 * response_;
  const auto windows = static_cast<std::size_t>(look / kWindow);
  const TrialRules rules;
  Overshoot run;
  const auto drive_at = [&](double f) {
    factor = std::min(options_.srf_max, f);
    set_factor(factor);
  };
  const auto raise = [&](double times) { drive_at(factor * times), simulation_.halt(), run = Overshoot(); };
  drive_at(factor), simulation_.halt();
  for (;; co_yield Pause{}) {
    const RelaxReport r = simulation_.relax(kWindow, {});
    run.steps += r.steps, run.looked += r.steps, progress_.steps += r.steps;
    progress_.unbalanced_force_ratio = r.unbalanced_force_ratio, progress_.max_displacement = r.max_displacement;
    if (r.diverged || run.steps > most) co_return;
    run.at_rest = r.unbalanced_force_ratio < rules.equilibrium ? run.at_rest + 1 : 0;
    if (run.at_rest > 0 && run.at_rest < rules.equilibrium_windows) continue;
    if (run.at_rest > 0) {  // a lower end for nothing
      stand(factor, run.steps, run.watch.wall(), r);
      if (factor >= options_.srf_max) co_return;
      raise(run.steps < 2 * response_ ? 1.2 : 1.06);
      continue;
    }
    const double level = r.max_displacement / simulation_.displacement_scale(), estimate = factor * r.power_ratio;
    run.flow.push_back({r.unbalanced_force_ratio, r.max_displacement, std::fmax(0, r.external_power), estimate});
    if (level > kLevel && estimate < factor && run.steady(windows)) {
      take_flow(run, estimate, run.mean(windows));
      co_return;
    }
    const bool far = level > rules.far;
    if (run.looked < look && !far) continue;
    run.looked = 0;
    if (r.unbalanced_force_ratio < kStands && r.unbalanced_force_ratio < 0.5 * run.unbalanced &&
        estimate > (1 - kFall) * factor && factor < options_.srf_max) {
      raise(1.2);
      continue;
    }
    run.unbalanced = r.unbalanced_force_ratio;
    if (estimate > run.best) run.best = estimate, run.best_state = simulation_.save(), run.falls = 0;
    else if (estimate < (1 - kFall) * run.best) ++run.falls;
    // F_e past its peak: a skin has run away or the section has softened; the flow at the peak is the one to follow.
    // F_e still creeping up: soil that hardens slowly (undrained) is read where hardening no longer counts
    if (run.falls >= 2 || far) {
      if (run.best_state == nullptr || !(run.best < factor)) co_return;
      take_flow(run, run.best, run.best);
      simulation_.restore(*run.best_state);
      co_return;
    }
    if (level > kFlowing && estimate < factor && factor < kBrisk * estimate) drive_at(kBrisk * estimate);
  }
}

/// Follows the flow down towards F_e, gently, until that repeats.
Slices GridSearch::come_down(double& factor) {
  constexpr double kFlat = 3e-4;  // F_e repeats when two rounds differ by less than this
  const auto peak = simulation_.save();
  const double read = flow_;
  for (int round = 0; round < 8; ++round) {
    const double before = flow_;
    factor = round == 0 ? std::min(flow_ + 0.6 * (factor - flow_), 1.01 * flow_) : 1.002 * flow_;
    set_factor(factor);
    simulation_.halt();
    for (std::int64_t n = 0; n < std::max<std::int64_t>(2 * kWindow, response_ / 2); n += kWindow) {
      const RelaxReport r = simulation_.relax(kWindow, {});
      progress_.steps += r.steps;
      if (r.unbalanced_force_ratio < 1e-5) break;
      flow_ = factor * r.power_ratio;
      co_yield Pause{};
      if (r.diverged) break;
    }
    if (!(std::fabs(flow_ / before - 1) < 2 * kFall)) {  // not the flow that was read: keep that one
      simulation_.restore(*peak);
      flow_ = read;
      break;
    }
    if (round > 0 && std::fabs(flow_ - before) < kFlat * flow_) break;
  }
}

}  // namespace vbgpd
