// Saved instants of a model: in memory, and as bytes for another process.
#include "arrays.h"
#include "exchange/checkpoint.h"
#include "guard.h"
#include "scene/difference.h"

namespace vbgpd::capi {
namespace {

CompileOptions options_of(const ContextObject& context, const Checkpoint& checkpoint) {
  CompileOptions options = context.options();
  options.spacing_factor = checkpoint.spacing_factor;
  options.lattice_multiple = checkpoint.lattice_multiple;
  options.coarsening = checkpoint.coarsening;
  return options;
}

/// Counts alone do not tell sections apart: one twice as large has as many particles.
void require_same_profile(const Simulation& simulation, const Checkpoint& checkpoint) {
  std::string difference = first_difference(simulation.scene(), checkpoint.scene);
  const CompileOptions& grid = simulation.options();
  if (difference.empty() &&
      (grid.spacing_factor != checkpoint.spacing_factor || grid.lattice_multiple != checkpoint.lattice_multiple ||
       grid.coarsening != checkpoint.coarsening))
    difference = "its grid is another one";
  if (!difference.empty())
    throw ArgumentError(2, Status::kFormat, "The checkpoint is of another profile: " + difference + ".");
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_save_state(const vbgpd_model* model, vbgpd_state** inout) {
  return with(model, [&](ModelObject& object) {
    require_not_null(inout, 2, "inout");
    std::shared_ptr<SavedState> saved = object.engine->simulation->save();
    if (*inout == nullptr) {
      auto state = std::make_unique<StateObject>();
      state->of = object.engine, state->saved = std::move(saved);
      hand_out(std::move(state), inout);
      return Status::kOk;
    }
    const Pinned<vbgpd_state> state(*inout);
    if (!state) throw ArgumentError(2, Status::kHandle, "*inout is neither NULL nor a live state.");
    const Inside inside(state->gate());
    require(inside, 2, "state");
    state->of = object.engine, state->saved = std::move(saved);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_restore_state(vbgpd_model* model, const vbgpd_state* state) {
  return with(model, [&](ModelObject& object) {
    const Pinned<const vbgpd_state> from(state);
    if (!from) throw ArgumentError(2, Status::kHandle, "The state is not a live state.");
    const Inside inside(from->gate());
    require(inside, 2, "state");
    if (from->of.lock() != object.engine)
      throw ArgumentError(2, Status::kArgument, "The state was saved from another model.");
    object.engine->to_change().restore(*from->saved);
    object.engine->events.forget(*object.engine->simulation);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_state_destroy(vbgpd_state* state) { return destroy(state); }

vbgpd_status vbgpd_model_checkpoint(const vbgpd_model* model, void* buf, int64_t cap, int64_t* needed) {
  return with(model, [&](ModelObject& object) {
    const Simulation& simulation = *object.engine->simulation;
    const CompileOptions& options = simulation.options();
    bytes_out(checkpoint_to_bytes({simulation.scene(), options.spacing_factor, options.lattice_multiple,
                                   options.coarsening, simulation.image()}),
              buf, cap, needed, 2);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_create_from_checkpoint(vbgpd_context* context, const void* bytes, int64_t len,
                                                vbgpd_model** out) {
  return with(context, [&](ContextObject& limits) {
    require_not_null(out, 4, "out");
    const Checkpoint checkpoint = checkpoint_from_bytes(bytes_in(bytes, len, 2));
    if (limits.max_particles > 0 && checkpoint.state.particles > limits.max_particles)
      throw ArgumentError(2, Status::kLimit,
                          "The checkpoint has " + std::to_string(checkpoint.state.particles) +
                              " particles; the context allows " + std::to_string(limits.max_particles) + ".");
    auto model = std::make_unique<ModelObject>();
    try {
      model->engine->simulation =
          Simulation::restored(checkpoint.scene, options_of(limits, checkpoint), checkpoint.state);
    } catch (const Error& error) {
      Issue issue = error.issue();
      const bool too_many_bytes = issue.object == ObjectKind::kContext;
      const bool of_the_bytes = issue.status != Status::kMemory && issue.status != Status::kVersion &&
                                issue.status != Status::kUnsupported && !too_many_bytes;
      if (of_the_bytes) issue.status = Status::kFormat;
      throw ArgumentError(2, issue);
    }
    model->engine->events.forget(*model->engine->simulation);
    hand_out(std::move(model), out);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_restore_checkpoint(vbgpd_model* model, const void* bytes, int64_t len) {
  return with(model, [&](ModelObject& object) {
    Simulation& simulation = object.engine->to_change();
    const Checkpoint checkpoint = checkpoint_from_bytes(bytes_in(bytes, len, 2));
    require_same_profile(simulation, checkpoint);
    simulation.restore_image(checkpoint.state);
    object.engine->events.forget(simulation);
    return Status::kOk;
  });
}
