#include "analysis/slice_job.h"

#include <cmath>
#include <new>

#include "analysis/stiffness_contrast.h"
#include "scene/wording.h"

namespace vbgpd {

namespace {

constexpr bool kWhole = true;
constexpr JobOption kOptions[] = {
    {"srf_min", "1", "lowest strength reduction factor tried", kNone, 1e-3, 1e3},
    {"srf_max", "1", "highest strength reduction factor tried", kNone, 1e-3, 1e3},
    {"srf_tolerance", "1", "width of the bracket asked for", kNone, 1e-4, 0.5},
    {"levels", "1", "grids: 1 plain, 2 extrapolated, 3 to 5 check the order; 0 = 2, or as many as the next two ask for",
     0, 0, 5, kWhole},
    {"target_error", "1", "ends when the error estimate is this small; 0 = no target", 0, 0, 1},
    {"budget", "s", "wall time within which grids are begun and ended; 0 = no limit", 0, 0, 1e9},
    {"careful", "1", "0 fast search, then verification; 1 plain bisection from the gravity state", 0, 0, 1, kWhole},
    {"stiffness_contrast", "1",
     "strength reduction: soils count as at most this many times as stiff as the softest one", kStiffnessContrast, 1,
     1e12},
    {"end_time", "s", "run-out: simulated time to stop at; 0 = at rest", 0, 0, 1e9},
    {"step_limit", "1", "steps after which a trial is undecided; 0 = 30 response times, careful 100", 0, 0, 1e12,
     kWhole},
};

/// A number of a result under its own name.
struct ResultNumber {
  const char* name;
  double JobResult::*value;
};
constexpr ResultNumber kNumbers[] = {
    {"factor_of_safety", &JobResult::factor_of_safety},
    {"srf_stable", &JobResult::srf_stable},
    {"srf_unstable", &JobResult::srf_unstable},
    {"error_estimate", &JobResult::error_estimate},
    {"displacement_level", &JobResult::displacement_level},
    {"sliding_area", &JobResult::sliding_area},
    {"energy_residual", &JobResult::energy_residual},
    {"unbalanced_force_ratio", &JobResult::unbalanced_force_ratio},
    {"max_displacement", &JobResult::max_displacement},
    {"crest_settlement", &JobResult::crest_settlement},
    {"toe_displacement", &JobResult::toe_displacement},
    {"runout_distance", &JobResult::runout_distance},
    {"moved_area", &JobResult::moved_area},
    {"plastic_fraction", &JobResult::plastic_fraction},
    {"observed_order", &JobResult::observed_order},
    {"next_level_spacing", &JobResult::next_level_spacing},
    {"next_level_seconds", &JobResult::next_level_seconds},
    {"wall_seconds", &JobResult::wall_seconds},
    {"cpu_seconds", &JobResult::cpu_seconds},
};

}  // namespace

void unknown_name(const char* what, std::string_view name, std::span<const std::string_view> known) {
  throw Error(Status::kUnknownName, std::string("A job has no ") + what + " named \"" + std::string(name) +
                                        "\": it has " + list_text(known) + suggestion_text(name, known));
}

std::span<const JobOption> job_options() { return kOptions; }

std::vector<std::string_view> job_numbers() {
  std::vector<std::string_view> names;
  for (const JobOption& option : kOptions) names.emplace_back(option.name);  // "levels" among them
  for (const ResultNumber& number : kNumbers) names.emplace_back(number.name);
  names.insert(names.end(), {"trials", "steps", "particles", "bonds"});
  return names;
}

void require_fixed_bonds(const Simulation& simulation, std::string_view what) {
  if (simulation.runs_out())
    throw Error(Status::kState,
                "a model that runs out has no " + std::string(what) + "; ask the model it was made from");
}

SliceJob::SliceJob(Simulation& simulation) : simulation_(simulation) {
  for (const JobOption& o : kOptions) options_[o.name] = o.default_value;
  const StrengthReductionDef& s = simulation.scene().strength_reduction;
  options_["srf_min"] = s.srf_min, options_["srf_max"] = s.srf_max, options_["srf_tolerance"] = s.tolerance;
}

Status SliceJob::run(double wall_seconds, const Callback& callback) {
  if (finished_) return outcome_;
  if (!started_) {
    check_options();
    slices_ = analysis(), started_ = true;
  }
  cancel_.store(false, std::memory_order_relaxed);
  const Stopwatch watch;
  Log* const log = simulation_.options().log.get();
  double called = 0;
  constexpr double kCallEvery = 0.1;
  const double cpu_before = result_.cpu_seconds, wall_before = result_.wall_seconds;
  Status status = Status::kOk;
  for (;;) {
    bool more = false;
    const auto over = [&](Status outcome, const char* word, std::string_view reason) {  // at every later call too
      finished_ = true, outcome_ = outcome, result_.status = word, result_.reason = reason;
    };
    try {
      more = slices_.next();
    } catch (const std::bad_alloc&) {
      over(Status::kMemory, "NO_MEMORY", "the analysis ran out of memory");
      throw;
    } catch (const Error& error) {
      over(error.issue().status, "REFUSED", error.issue().text);
      throw;
    } catch (...) {
      over(Status::kInternal, "INTERNAL", "the analysis stopped on an internal error");
      throw;
    }
    const double now = watch.wall();
    result_.wall_seconds = wall_before + now;
    result_.cpu_seconds = cpu_before + watch.cpu();
    result_.steps = progress_.steps;
    teller_.look(log, progress_, result_);
    if (!more) {
      finished_ = true;
      progress_.fraction = 1;
      teller_.end(log, outcome_, result_);
      return outcome_;
    }
    if (callback && now - called >= kCallEvery) {
      called = now;
      if (!callback(progress_)) status = Status::kCancelled;
    }
    if (cancel_.load(std::memory_order_relaxed)) status = Status::kCancelled;
    if (status == Status::kOk && wall_seconds > 0 && now >= wall_seconds) status = Status::kLimitReached;
    if (status != Status::kOk) return status;
  }
}

void SliceJob::set(std::string_view name, double value) {
  for (const JobOption& o : kOptions) {
    if (name != o.name) continue;
    if (started_) throw Error(Status::kState, std::string(name) + ": options can be set before the first run only");
    const bool broken = o.whole && value != std::floor(value);
    if (broken || !(value >= o.min_value && value <= o.max_value)) {
      Issue issue;
      issue.status = Status::kRange, issue.object = ObjectKind::kJob, issue.value = value;
      issue.text = std::string(name) + " = " + number_text(value) + ": must be " + (o.whole ? "a whole number " : "") +
                   "in [" + number_text(o.min_value) + ", " + number_text(o.max_value) + "]";
      throw Error(issue);
    }
    options_[o.name] = value;
    return;
  }
  std::vector<std::string_view> known;
  for (const JobOption& o : kOptions) known.emplace_back(o.name);
  unknown_name("option", name, known);
}

double SliceJob::get(std::string_view name) const {
  const JobResult& r = result_;
  if (const auto found = options_.find(std::string(name)); found != options_.end() && name != "levels")
    return found->second;
  for (const ResultNumber& number : kNumbers)
    if (name == number.name) return r.*number.value;
  if (name == "levels") return started_ ? static_cast<double>(r.levels.size()) : option("levels");
  if (name == "trials") return static_cast<double>(r.trials.size());
  if (name == "steps") return static_cast<double>(r.steps);
  if (name == "particles") return static_cast<double>(simulation_.particle_count());
  if (name == "bonds") return static_cast<double>(simulation_.bond_count());
  unknown_name("number", name, job_numbers());
}

}  // namespace vbgpd
