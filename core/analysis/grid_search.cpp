#include "analysis/grid_search.h"

#include <algorithm>
#include <cmath>

#include "analysis/stiffness_contrast.h"
#include "scene/wording.h"

namespace vbgpd {

namespace {

constexpr double kNotch =
    0.25;  // trial factors are multiples of this share of the tolerance: the same for every unit and side

constexpr int kBriefly = 4;    // response times a trial may take where another factor beside it would do
constexpr int kLong = 14;      // ... where one further away would do
constexpr int kCareful = 100;  // ... where plain bisection is asked for: untouched soil takes long near its limit

/// The masses of the relaxation follow the stiffness: a mechanism in the stiffest soil gathers speed so many times more
/// slowly than one in the softest, which the elastic response does not show.
double slowness(const Simulation& simulation) {
  constexpr double kMost = 32;  // a thousandfold stiffness; beyond that nobody would wait
  return std::min(std::sqrt(stiffness_contrast(simulation).ratio), kMost);
}

}  // namespace

void GridSearch::set_factor(double factor) {
  simulation_.set("strength_reduction_factor", factor);
  progress_.strength_reduction_factor = factor;
}

double GridSearch::notched(double factor) const {
  const double notch = kNotch * options_.tolerance;
  return notch * std::floor(factor / notch + 1e-9);
}

/// Where the bracket is cut: below the factor the flow would balance at, then above it, for near it a slope neither
/// rests nor flows; in the middle where that is not known; beside that after an undecided trial there. Where one more
/// verdict closes it either way, as low as that allows: the lower, the sooner it stands.
double GridSearch::middle() const {
  const double above = std::fmin(failure_.factor, runaway_), width = above - stable_;
  const double notch = kNotch * options_.tolerance;
  double cut = (stable_ + above) / 2;
  constexpr double kBeside[] = {0, 0.25, -0.25, 0.375, -0.375};
  const auto inside = [&](double f) { return f > stable_ + 0.5 * notch && f < above - 0.5 * notch; };
  const double below = notched(flow_ - 0.5 * notch);
  if (aside_ > 0) cut += width * kBeside[std::min<std::size_t>(aside_, std::size(kBeside) - 1)];
  else if (inside(below)) cut = below;
  else if (inside(below + options_.tolerance)) cut = below + options_.tolerance;
  else if (width <= 2 * options_.tolerance) cut = above - options_.tolerance;
  return notched(cut + 0.5 * notch);
}

/// A slope may all but balance over a range of factors, neither at rest nor failing: for every two factors in there
/// that were tried for as long as allowed, the bracket may be wider by the tolerance.
bool GridSearch::closed() const {
  const auto inside = [&](double f) { return f > stable_ && f < failure_.factor; };
  const auto pairs = std::count_if(balanced_.begin(), balanced_.end(), inside) / 2;
  return failure_.factor - stable_ <= options_.tolerance * (1 + static_cast<double>(pairs)) * (1 + 1e-9);
}

void GridSearch::end_below() {
  end_ = SearchEnd::kBelowMin, done_ = true;
  reason_ = "the slope fails even at the lowest strength reduction factor asked, " + number_text(options_.srf_min);
}

void GridSearch::end_above() {
  end_ = SearchEnd::kAboveMax, done_ = true;
  reason_ = "the slope stands even at the highest strength reduction factor asked, " + number_text(options_.srf_max);
}

/// Elastic equilibrium under weight and loads; its steps are the response time N_r of the section.
Slices GridSearch::gravity() {
  progress_.phase = Phase::kGravity;
  set_factor(1);
  simulation_.halt();
  RelaxOptions elastic;
  elastic.elastic = true;
  constexpr double kAtRest = 1e-6;
  constexpr std::int64_t kMost = 200000;
  for (;;) {
    const RelaxReport r = simulation_.relax(kWindow, elastic);
    response_ += r.steps, progress_.steps += r.steps;
    elastic_displacement_ = r.max_displacement;
    progress_.unbalanced_force_ratio = r.unbalanced_force_ratio, progress_.max_displacement = r.max_displacement;
    if (r.diverged || response_ >= kMost) {
      end_ = r.diverged ? SearchEnd::kDiverged : SearchEnd::kNoGravity, done_ = true;
      reason_ = r.diverged ? "the elastic gravity state diverged" : "the elastic gravity state did not come to rest";
      co_return;
    }
    if (r.unbalanced_force_ratio < kAtRest) break;
    co_yield Pause{};
  }
  response_ = std::max<std::int64_t>(response_, 4 * kWindow);
  response_ = static_cast<std::int64_t>(static_cast<double>(response_) * slowness(simulation_));
  simulation_.halt();
  gravity_ = standing_ = simulation_.save();
}

/// One trial from the present state; its verdict moves an end of the bracket.
Slices GridSearch::try_factor(double factor, Phase phase) {
  progress_.phase = phase;
  set_factor(factor);
  trials_.push_back({});
  Trial trial;
  trial.level = level_, trial.strength_reduction_factor = factor;
  progress_.trial = static_cast<int>(trials_.size()) - 1;
  TrialRules rules;
  rules.step_limit = options_.step_limit, rules.patience = patience_;
  rules.drive = 0.5 * kNotch * options_.tolerance / factor;
  if (patience_ == kBriefly) rules.balanced = kNotch * options_.tolerance / factor;
  TrialRun run(simulation_, rules, response_, elastic_displacement_);
  for (Slices s = run.run(trial, progress_); s.next();) {
    trials_.back() = trial;
    co_yield Pause{};
  }
  trials_.back() = trial;
  verdict_ = trial.verdict;
  aside_ = trial.verdict == Verdict::kUndecided ? aside_ + 1 : 0;
  if (run.diverged()) run_away(factor);
  else if (trial.verdict != Verdict::kStable && !std::isnan(flow_)) flow_ = trial.power_ratio;
  if (trial.verdict == Verdict::kStable) {
    stable_ = std::isnan(stable_) ? factor : std::max(stable_, factor);
    standing_ = simulation_.save();
  }
  if (trial.verdict == Verdict::kFailed) {
    if (!(failure_.factor <= factor))
      failure_ = {factor,          trial.power_ratio, trial.displacement_level, trial.unsteadiness,
                  trial.hardening, simulation_.save()};
    constexpr double kGathers = 0.5;
    gathers_force_ = trial.unbalanced_force_slope > kGathers;
  }
  if (trial.verdict == Verdict::kUndecided && !run.diverged()) set_aside(trial);
  if (runaway_ - stable_ <= options_.tolerance * (1 + 1e-9) && !(failure_.factor <= runaway_))
    end_ = SearchEnd::kDiverged, done_ = true;
  progress_.srf_stable = stable_, progress_.srf_unstable = failure_.factor;
}

/// Displacements that run away are no verdict: the flow was too fast to follow, a slower one is looked for below.
void GridSearch::run_away(double factor) {
  constexpr int kMost = 8;  // a bisection from far above down to the tolerance
  simulation_.restore(*standing_);
  aside_ = 0;
  runaway_ = std::fmin(runaway_, factor);
  reason_ = "displacements ran away at F = " + number_text(factor);
  if (++runaways_ >= kMost) end_ = SearchEnd::kDiverged, done_ = true;
}

/// A factor that could not be decided is no verdict: another one is tried beside it, from where this one got to, a few
/// times.
void GridSearch::set_aside(const Trial& trial) {
  constexpr double kMost = 6;  // as many as run out of the whole patience, or more that were given up sooner
  reason_ = "at F = " + number_text(trial.strength_reduction_factor) +
            " neither equilibrium nor steady failure showed within " + std::to_string(trial.steps) +
            " steps (unbalanced force ratio " + number_text(trial.unbalanced_force_ratio) + ")";
  patience_ = std::min(2 * patience_, longest_);
  const std::int64_t longest = options_.step_limit > 0 ? options_.step_limit : longest_ * response_;
  if (trial.steps >= longest) balanced_.insert(trial.strength_reduction_factor);
  undecided_ += std::max(0.5, static_cast<double>(trial.steps) / static_cast<double>(longest));
  if (undecided_ >= kMost) end_ = SearchEnd::kNotConverged, done_ = true;
}

/// The slope came to rest at a factor it was to flow at: a trial like any other.
void GridSearch::stand(double factor, std::int64_t steps, double seconds, const RelaxReport& r) {
  Trial trial;
  trial.level = level_, trial.strength_reduction_factor = factor, trial.verdict = Verdict::kStable;
  trial.unbalanced_force_ratio = r.unbalanced_force_ratio, trial.steps = steps;
  trial.displacement_level = r.max_displacement / simulation_.displacement_scale();
  trial.wall_seconds = seconds;
  trials_.push_back(trial);
  stable_ = factor, standing_ = simulation_.save();
  progress_.trial = static_cast<int>(trials_.size()) - 1, progress_.srf_stable = stable_;
}

/// The two ends of the bracket around the flow factor: arrest below it, keep flowing above it, halve what is left.
Slices GridSearch::fast_bracket() {
  followed_flow_ = flow_;
  for (Slices s = lower_end(); s.next();) co_yield Pause{};
  if (!done_ && std::isnan(flow_)) {  // soil that the flow has worn out fails below what untouched soil bears
    for (Slices s = bisection(); s.next();) co_yield Pause{};
    co_return;
  }
  for (Slices s = upper_end(); s.next();) co_yield Pause{};
  for (Slices s = halve(); s.next();) co_yield Pause{};
  constexpr double kWorn = 0.003, kStray = 0.03;
  constexpr double kOverread = 0.003;  // of a brisk flow, at most: F_e falls by that when it slows down
  const bool softened = gathers_force_ && failure_.flow < (1 - kOverread) * fresh_flow_ - options_.tolerance;
  const bool worn = failure_.flow < (1 - kWorn) * first_failing_flow_;
  const bool strayed = stable_ > (1 + kStray) * followed_flow_;
  const bool kept = failure_.flow >= (1 - kOverread) * fresh_flow_;  // else that flow was too brisk to tell
  failure_.hardening = kept ? flow_hardening_ : 0;
  if (!done_ && (softened || worn || strayed))
    for (Slices s = upper_end_from_gravity(); s.next();) co_yield Pause{};
}

/// The same flow comes to rest; if not, it goes on at the factor it would balance at by now, or further down. flow_ is
/// NaN where it has worn the soil out.
Slices GridSearch::lower_end() {
  constexpr double kWornOut = 0.04;
  const double notch = kNotch * options_.tolerance;
  const double first = std::max(options_.srf_min, notched(flow_));
  patience_ = kLong;
  double low = first;
  for (double step = 2 * notch; !done_ && !(stable_ >= low);) {
    for (Slices s = try_factor(low, Phase::kStableEnd); s.next();) co_yield Pause{};
    if (done_ || verdict_ == Verdict::kStable) break;
    if (verdict_ == Verdict::kFailed && (low <= options_.srf_min || flow_ < (1 - kWornOut) * first_failing_flow_)) {
      failure_ = {}, flow_ = kNone, balanced_.clear();
      options_.guess = first;
      co_return;
    }
    double balance = flow_ - notch;  // undecided: the flow is all but in balance, stay clear of that
    if (verdict_ == Verdict::kFailed) {
      if (std::isnan(first_failing_flow_)) first_failing_flow_ = flow_;
      balance = std::min(low - step, flow_), step *= 2;
    }
    low = std::max(options_.srf_min, notched(std::min(low - notch, balance)));
  }
}

/// From the state at rest, a little more; if it stands, it is the new lower end; where it creeps, a notch more, then
/// two, going on from there.
Slices GridSearch::upper_end() {
  const double notch = kNotch * options_.tolerance;
  patience_ = kBriefly;
  double step = options_.tolerance, aside = notch;
  for (double high = stable_ + step; !done_ && !(failure_.factor <= high) && !(runaway_ <= high);) {
    high = std::min(options_.srf_max, notched(high + 0.5 * notch));
    for (Slices s = try_factor(high, Phase::kFailedEnd); s.next();) co_yield Pause{};
    if (!done_ && verdict_ == Verdict::kStable && high >= options_.srf_max) {
      end_above();
      co_return;
    }
    high += verdict_ == Verdict::kStable ? step *= 2 : aside;
    if (verdict_ == Verdict::kUndecided) aside *= 2;
  }
}

/// Between a standing and a failing factor further apart than asked. A flow below what it would balance at is soon
/// arrested (one that has not hardened on its way), and soil at rest soon flows above that; the other way round takes
/// long. From how far an undecided one got, in any case.
Slices GridSearch::halve() {
  constexpr double kHardened = 0.003;
  patience_ = longest_;
  while (!done_ && !closed()) {
    const double factor = middle();
    const bool arrest = failure_.state && factor < flow_ && flow_ < (1 + kHardened) * followed_flow_;
    if (verdict_ != Verdict::kUndecided) simulation_.restore(arrest ? *failure_.state : *standing_);
    for (Slices s = try_factor(factor, Phase::kFailedEnd); s.next();) co_yield Pause{};
  }
}

/// Non-associated soil may soften while it flows (unbalanced force that grows is a sign where F_e has fallen since the
/// flow was fresh, F_e that falls while the flow is followed down another): then a failure reached through a flow holds
/// for softened soil only, and the upper end is shown again from the untouched gravity state. So is that of a bracket
/// far above where the flow was read: soil that dilates changes the longer it flows.
Slices GridSearch::upper_end_from_gravity() {
  const double notch = kNotch * options_.tolerance;
  const Failure through_flow = failure_;
  double factor = failure_.factor;
  failure_ = {}, balanced_.clear();
  // where gravity alone cannot tell, the failure shown through the flow stands
  const double undecided = undecided_;
  const auto flow_holds = [&] { return through_flow.factor > stable_; };
  const auto settled = [&] { return done_ || closed() || (undecided_ > undecided && flow_holds()); };
  for (double step = 2 * notch; !settled() && std::isnan(failure_.factor) && !(runaway_ <= factor); step *= 2) {
    simulation_.restore(*gravity_);
    for (Slices s = try_factor(factor, Phase::kFailedEnd); s.next();) co_yield Pause{};
    if (!done_ && verdict_ == Verdict::kStable && factor >= options_.srf_max) {
      end_above();
      co_return;
    }
    factor = std::min(options_.srf_max, notched(factor + step + 0.5 * notch));
  }
  while (!settled()) {
    simulation_.restore(*gravity_);
    for (Slices s = try_factor(middle(), Phase::kFailedEnd); s.next();) co_yield Pause{};
  }
  if (!closed() && flow_holds() && !(done_ && end_ != SearchEnd::kNotConverged)) {
    done_ = false;
    failure_ = through_flow, progress_.srf_unstable = failure_.factor;
  }
}

/// Plain bisection, every trial from the gravity state.
Slices GridSearch::bisection() {
  patience_ = longest_;
  const auto from_gravity = [&] { simulation_.restore(*gravity_); };
  double factor = std::clamp(std::isnan(options_.guess) ? 1.0 : options_.guess, options_.srf_min, options_.srf_max);
  for (double step = 1.25; !done_ && (std::isnan(stable_) || std::isnan(std::fmin(failure_.factor, runaway_)));
       step = std::min(2.0, step * 1.1)) {
    from_gravity();
    for (Slices s = try_factor(factor, Phase::kSearch); s.next();) co_yield Pause{};
    if (done_) co_return;
    if (verdict_ == Verdict::kUndecided) {
      factor = std::clamp(runaway_ <= factor ? factor / step : factor * 0.97, options_.srf_min, options_.srf_max);
      continue;
    }
    const bool stood = verdict_ == Verdict::kStable;
    if (stood && factor >= options_.srf_max) {
      end_above();
    }
    if (!stood && factor <= options_.srf_min) {
      end_below();
    }
    factor = std::clamp(stood ? factor * step : factor / step, options_.srf_min, options_.srf_max);
  }
  while (!done_ && !closed()) {
    from_gravity();
    for (Slices s = try_factor(middle(), Phase::kFailedEnd); s.next();) co_yield Pause{};
  }
}

Slices GridSearch::run() {
  if (options_.careful) longest_ = kCareful;
  for (Slices s = gravity(); s.next();) co_yield Pause{};
  if (done_) co_return;
  if (!options_.careful) {
    for (Slices s = follow(); s.next();) co_yield Pause{};
    if (std::isnan(flow_) && stable_ >= options_.srf_max) {
      end_above();
      co_return;
    }
  }
  if (!std::isnan(flow_)) {
    for (Slices s = fast_bracket(); s.next();) co_yield Pause{};
  } else {
    for (Slices s = bisection(); s.next();) co_yield Pause{};
  }
  if (done_) co_return;
  end_ = SearchEnd::kBracketed;
  simulation_.restore(*failure_.state);
}

}  // namespace vbgpd
