// Models: compile a profile, step it, its named numbers.
#include <chrono>
#include <cmath>

#include "convert.h"
#include "guard.h"
#include "listener.h"
#include "plan.h"
#include "scene/wording.h"

namespace vbgpd::capi {
namespace {

vbgpd_advance_result result_of(const Simulation& simulation, const StepReport& report, const Monitors& monitors) {
  vbgpd_advance_result result{};
  result.struct_size = sizeof result;
  result.steps = report.steps;
  result.time = simulation.get("time");
  result.time_step = simulation.get("time_step");
  result.kinetic_energy = monitors.kinetic_energy;
  result.unbalanced_force_ratio = monitors.unbalanced_force_ratio;
  result.max_displacement = monitors.max_displacement;
  result.max_velocity = monitors.max_velocity;
  result.plastic_bonds = monitors.plastic_bonds;
  return result;
}

[[noreturn]] void report_divergence(const vbgpd_advance_result& last_good, const char* cause) {
  Issue issue;
  issue.status = Status::kDiverged;
  issue.object = ObjectKind::kModel;
  issue.value = last_good.time;
  issue.text = "The model diverged after " + std::to_string(last_good.steps) + " steps of this call: " + cause +
               "; it is back at its last good step, at " + number_text(last_good.time) + " s.";
  throw Error(issue);
}

Status conclude(ModelObject& object, const StepReport& report, vbgpd_advance_result* r) {
  // A request is used up by the call that obeys it; one that came too late stops the next call.
  if (report.status == Status::kCancelled) object.cancel.store(false, std::memory_order_relaxed);
  Engine& engine = *object.engine;
  const Monitors monitors = engine.simulation->monitors_after(report);
  engine.events.look(*engine.simulation, monitors, report);
  const vbgpd_advance_result result = result_of(*engine.simulation, report, monitors);
  fill(r, result);
  if (report.status == Status::kDiverged) report_divergence(result, report.cause);
  return report.status;
}

/// What ends a slice of _advance_to before its time, asked between any two steps.
class Slice {
 public:
  using Clock = std::chrono::steady_clock;
  Slice(ModelObject& object, const Simulation& simulation, double end, double wall_seconds, Listener& listener)
      : object_(object),
        simulation_(simulation),
        listener_(listener),
        first_(simulation.get("time")),
        end_(end),
        wall_seconds_(wall_seconds) {}

  Status between_steps() {
    if (object_.cancel.load(std::memory_order_relaxed)) return Status::kCancelled;
    const double now = std::chrono::duration<double>(Clock::now() - start_).count();
    if (wall_seconds_ > 0 && now >= wall_seconds_) return Status::kLimitReached;
    constexpr double kCallEvery = 0.1;
    if (listener_.present() && now - called_ >= kCallEvery) {
      called_ = now;
      if (!listener_.go_on(progress())) return Status::kCancelled;
    }
    return Status::kOk;
  }

 private:
  vbgpd_progress progress() const {
    const Monitors monitors = simulation_.monitors();
    vbgpd_progress told{};
    told.struct_size = sizeof told;
    told.steps = static_cast<std::int64_t>(simulation_.get("steps"));
    told.fraction = (simulation_.get("time") - first_) / (end_ - first_);
    told.strength_reduction_factor = simulation_.get("strength_reduction_factor");
    told.srf_stable = told.srf_unstable = kNone;
    told.unbalanced_force_ratio = monitors.unbalanced_force_ratio;
    told.max_displacement = monitors.max_displacement;
    return told;
  }

  ModelObject& object_;
  const Simulation& simulation_;
  Listener& listener_;
  double first_, end_, wall_seconds_, called_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_create(vbgpd_context* context, const vbgpd_profile* profile, vbgpd_model** out) {
  return with(context, [&](ContextObject& limits) {
    require_not_null(out, 3, "out");
    const Pinned<const vbgpd_profile> source(profile);
    if (!source) throw ArgumentError(2, Status::kHandle, "The profile is not a live profile.");
    const Inside inside(source->gate());
    require(inside, 2, "profile");
    auto model = std::make_unique<ModelObject>();
    try {
      model->engine->simulation = Simulation::compile(source->scene, limits.options());
    } catch (const Error& error) {
      throw ArgumentError(2, error.issue());
    }
    hand_out(std::move(model), out);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_destroy(vbgpd_model* model) { return destroy(model); }

vbgpd_status vbgpd_model_set_f64(vbgpd_model* model, const char* name, int64_t len, double value) {
  return with(model, [&](ModelObject& object) {
    object.engine->to_change().set(text_in(name, len, 2, "name"), value);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_get_f64(const vbgpd_model* model, const char* name, int64_t len, double* value) {
  return with(model, [&](ModelObject& object) {
    require_not_null(value, 4, "value");
    const std::string_view key = text_in(name, len, 2, "name");
    const std::optional<double> forecast = forecast_of(*object.engine, key);
    *value = forecast ? *forecast : object.engine->simulation->get(key);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_step(vbgpd_model* model, int64_t steps, vbgpd_advance_result* r) {
  return with(model, [&](ModelObject& object) {
    if (steps < 0) {
      throw ArgumentError(2, Status::kArgument,
                          "The number of steps is " + std::to_string(steps) + "; it must be 0 or more.");
    }
    require_struct(r, 3, true);
    Simulation& simulation = object.engine->to_change();
    return conclude(object, simulation.step(steps, &object.cancel), r);
  });
}

vbgpd_status vbgpd_model_advance_to(vbgpd_model* model, double time, double wall_seconds, vbgpd_progress_fn fn,
                                    void* user, vbgpd_advance_result* r) {
  std::fenv_t callers;
  std::fegetenv(&callers);
  return with(model, [&](ModelObject& object) {
    if (std::isnan(wall_seconds)) throw ArgumentError(3, Status::kArgument, "wall_seconds is not a number.");
    require_struct(r, 6, true);
    Simulation& simulation = object.engine->to_change();
    Listener listener(fn, user, callers);
    Slice slice(object, simulation, time, wall_seconds, listener);
    StepReport report;
    try {
      report = simulation.advance_to(time, [&slice] { return slice.between_steps(); });
    } catch (const Error& error) {
      throw ArgumentError(2, error.issue());
    }
    const Status status = conclude(object, report, r);
    if (listener.threw()) throw ArgumentError(4, Status::kInternal, "The progress function threw an exception.");
    return status;
  });
}

vbgpd_status vbgpd_model_epoch(const vbgpd_model* model, int64_t* epoch) {
  return with(model, [&](ModelObject& object) {
    require_not_null(epoch, 2, "epoch");
    *epoch = object.engine->simulation->epoch();
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_cancel(vbgpd_model* model) {
  const Pinned<vbgpd_model> object(model);
  if (!object) return VBGPD_E_HANDLE;
  object->cancel.store(true, std::memory_order_relaxed);
  return VBGPD_OK;
}
