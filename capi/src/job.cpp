// Jobs: long analyses in slices.
#include <cmath>
#include <optional>

#include "convert.h"
#include "guard.h"
#include "listener.h"

namespace vbgpd::capi {
namespace {

vbgpd_progress progress_of(const Progress& from) {
  vbgpd_progress to{};
  to.struct_size = sizeof to;
  to.level = from.level;
  to.trial = from.trial;
  to.phase = static_cast<std::int32_t>(from.phase);
  to.steps = from.steps;
  to.fraction = from.fraction;
  to.strength_reduction_factor = from.strength_reduction_factor;
  to.srf_stable = from.srf_stable;
  to.srf_unstable = from.srf_unstable;
  to.unbalanced_force_ratio = from.unbalanced_force_ratio;
  to.max_displacement = from.max_displacement;
  return to;
}

// A slice. Whoever cancels between two slices, or as one begins, is heard too: the request stands until a slice obeyed
// it.
Status run_slice(JobObject& object, double wall_seconds, Listener& listener) {
  const auto cancelled = [&object] { return object.cancel.load(std::memory_order_relaxed); };
  Status status = Status::kCancelled;
  if (object.job->finished() || !cancelled()) {
    status = object.job->run(
        wall_seconds, [&](const Progress& progress) { return listener.go_on(progress_of(progress)) && !cancelled(); });
  }
  if (status == Status::kCancelled || object.job->finished()) object.cancel.store(false, std::memory_order_relaxed);
  return status;
}

bool found_a_mechanism(const Job& job) {
  return job.result().status == "UNSTABLE" || !job.result().slip_surface.empty();
}

[[noreturn]] void report_divergence(const Job& job) {
  Issue issue;
  issue.status = Status::kDiverged;
  issue.object = ObjectKind::kJob;
  issue.text =
      job.result().reason.empty() ? "The model diverged; it is back at its last good step." : job.result().reason;
  throw Error(issue);
}

// However a slice ends: a job that has finished, or was refused before it began, counts on its model no longer.
class JobEnds {
 public:
  explicit JobEnds(JobObject& object) : object_(object) {}
  ~JobEnds() {
    if (object_.job->finished() || !object_.job->started()) object_.end();
  }
  JobEnds(const JobEnds&) = delete;
  JobEnds& operator=(const JobEnds&) = delete;

 private:
  JobObject& object_;
};

using MakeJob = std::unique_ptr<Job> (*)(Simulation&);

vbgpd_status create_job(vbgpd_model* model, vbgpd_job** out, MakeJob make) noexcept {
  return with(model, [&](ModelObject& parent) {
    require_not_null(out, 2, "out");
    auto object = std::make_unique<JobObject>(parent.engine);
    object->job = make(*parent.engine->simulation);
    hand_out(std::move(object), out);
    return Status::kOk;
  });
}

vbgpd_trial trial_of(const Trial& from) {
  vbgpd_trial to{};
  to.struct_size = sizeof to;
  to.level = from.level;
  to.verdict = static_cast<std::int32_t>(from.verdict);
  to.band_connected = from.band_connected ? 1 : 0;
  to.strength_reduction_factor = from.strength_reduction_factor;
  to.unbalanced_force_ratio = from.unbalanced_force_ratio;
  to.unbalanced_force_slope = from.unbalanced_force_slope;
  to.displacement_level = from.displacement_level;
  to.displacement_growth = from.displacement_growth;
  to.power_ratio = from.power_ratio;
  to.steps = from.steps;
  to.wall_seconds = from.wall_seconds;
  return to;
}

vbgpd_level level_of(const Level& from) {
  vbgpd_level to{};
  to.struct_size = sizeof to;
  to.spacing_x = from.spacing_x;
  to.spacing_y = from.spacing_y;
  to.particles = from.particles;
  to.bonds = from.bonds;
  to.steps = from.steps;
  to.trials = from.trials;
  to.srf_stable = from.srf_stable;
  to.srf_unstable = from.srf_unstable;
  to.factor_of_safety = from.factor_of_safety;
  to.wall_seconds = from.wall_seconds;
  to.cpu_seconds = from.cpu_seconds;
  to.estimate = from.estimate;
  to.error_estimate = from.error_estimate;
  to.sliding_area = from.sliding_area;
  return to;
}

/// What the engine says of a name, argument 2.
template <class Ask>
auto by_name(const Ask& ask) {
  try {
    return ask();
  } catch (const Error& error) {
    if (error.issue().status != Status::kUnknownName) throw;
    throw ArgumentError(2, error.issue());
  }
}

const std::string& named_text(const JobResult& result, std::string_view name) {
  if (name == "status") return result.status;
  if (name == "reason") return result.reason;
  if (name == "scheme") return result.scheme;
  if (name == "reduced") return result.reduced;
  if (name == "flow_rule") return result.flow_rule;
  static constexpr std::string_view kTexts[] = {"status", "reason", "scheme", "reduced", "flow_rule"};
  unknown_name("text", name, kTexts);
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_job_create_equilibrium(vbgpd_model* model, vbgpd_job** out) {
  return create_job(model, out, make_equilibrium);
}

vbgpd_status vbgpd_job_create_strength_reduction(vbgpd_model* model, vbgpd_job** out) {
  return create_job(model, out, make_strength_reduction);
}

vbgpd_status vbgpd_job_create_runout(vbgpd_model* model, vbgpd_job** out) {
  return create_job(model, out, make_runout_job);
}

vbgpd_status vbgpd_job_set_f64(vbgpd_job* job, const char* name, int64_t len, double value) {
  return with(job, [&](JobObject& object) {
    const std::string_view key = text_in(name, len, 2, "name");
    by_name([&] { object.job->set(key, value); });
    return Status::kOk;
  });
}

vbgpd_status vbgpd_job_run(vbgpd_job* job, double wall_seconds, vbgpd_progress_fn fn, void* user, vbgpd_progress* p) {
  std::fenv_t callers;
  std::fegetenv(&callers);
  return with(job, [&](JobObject& object) {
    if (std::isnan(wall_seconds)) throw ArgumentError(2, Status::kArgument, "wall_seconds is not a number.");
    require_struct(p, 5, true);
    const Inside inside(object.engine->gate);
    require(inside, 1, "model of this job");
    if (!object.job->finished()) object.begin();
    const bool ended_before = object.job->finished();
    const JobEnds ends(object);
    Listener listener(fn, user, callers);
    const Status status = run_slice(object, wall_seconds, listener);
    if (object.job->finished() && !ended_before && found_a_mechanism(*object.job))
      object.engine->events.mechanism(*object.engine->simulation);
    fill(p, progress_of(object.job->progress()));
    if (listener.threw()) throw ArgumentError(3, Status::kInternal, "The progress function threw an exception.");
    if (status == Status::kDiverged) report_divergence(*object.job);
    if (static_cast<std::int32_t>(status) < 0) throw Error(status, object.job->result().reason);
    return status;
  });
}

vbgpd_status vbgpd_job_cancel(vbgpd_job* job) {
  const Pinned<vbgpd_job> object(job);
  if (!object) return VBGPD_E_HANDLE;
  object->cancel.store(true, std::memory_order_relaxed);
  object->job->cancel();
  return VBGPD_OK;
}

vbgpd_status vbgpd_job_get_f64(const vbgpd_job* job, const char* name, int64_t len, double* value) {
  return with(job, [&](JobObject& object) {
    require_not_null(value, 4, "value");
    const std::string_view key = text_in(name, len, 2, "name");
    std::optional<Inside> model;  // what is read off the model, which another thread may be stepping
    if (key == "particles" || key == "bonds") require(model.emplace(object.engine->gate), 1, "model of this job");
    *value = by_name([&] { return object.job->get(key); });
    return Status::kOk;
  });
}

vbgpd_status vbgpd_job_get_text(const vbgpd_job* job, const char* name, int64_t len, char* buf, int64_t cap,
                                int64_t* needed) {
  return with(job, [&](JobObject& object) {
    const std::string_view key = text_in(name, len, 2, "name");
    text_out(by_name([&] { return named_text(object.job->result(), key); }), buf, cap, needed, 4);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_job_trial(const vbgpd_job* job, int64_t i, vbgpd_trial* t) {
  return with(job, [&](JobObject& object) {
    require_struct(t, 3);
    const Trial* const trial = item_at(object.job->result().trials, i, 2);
    if (trial == nullptr) return Status::kEndOfData;
    fill(t, trial_of(*trial));
    return Status::kOk;
  });
}

vbgpd_status vbgpd_job_level(const vbgpd_job* job, int64_t i, vbgpd_level* l) {
  return with(job, [&](JobObject& object) {
    require_struct(l, 3);
    const Level* const level = item_at(object.job->result().levels, i, 2);
    if (level == nullptr) return Status::kEndOfData;
    fill(l, level_of(*level));
    return Status::kOk;
  });
}

vbgpd_status vbgpd_job_slip_surface(const vbgpd_job* job, double* xy, int64_t stride, int64_t cap, int64_t* n) {
  return with(job, [&](JobObject& object) {
    points_out(object.job->result().slip_surface, xy, stride, cap, n, 2);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_job_destroy(vbgpd_job* job) { return destroy(job); }
