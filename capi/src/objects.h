// What the five handles stand for. Children share what they need of their parents, so any order of destruction is
// right.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "analysis/job.h"
#include "events.h"
#include "handles.h"
#include "log.h"
#include "scene/scene_def.h"
#include "simulation/simulation.h"

namespace vbgpd::capi {

struct ContextObject : Object {
  static constexpr ObjectKind kKind = ObjectKind::kContext;
  ContextObject() : Object(kKind) {}
  ~ContextObject() override { log->fall_silent(); }
  CompileOptions options() const {
    CompileOptions o;
    o.threads = threads, o.max_particles = max_particles, o.max_bytes = max_bytes, o.log = log;
    o.heap = heap;
    return o;
  }
  int threads = 1;
  std::int64_t max_particles = 0, max_bytes = 0;
  Heap heap;
  std::shared_ptr<LogRing> log = std::make_shared<LogRing>();  ///< shared with the models made here
};

struct ProfileObject : Object {
  static constexpr ObjectKind kKind = ObjectKind::kProfile;
  ProfileObject() : Object(kKind) {}
  SceneDef scene;
  std::vector<Issue> issues;  ///< of the last validation
};

/// A simulation with its gate: one thread at a time, be it through the model or through one of its jobs.
struct Engine {
  std::unique_ptr<Simulation> simulation;
  Gate gate;
  std::vector<std::int64_t> leases;  ///< of views that are held
  std::int64_t last_lease = 0;
  EventLog events;
  std::atomic<const void*> open_job{nullptr};  ///< begun and not finished; a job may end without the gate

  /// The simulation for a call that changes it; throws while views are held or a job is under way.
  Simulation& to_change() const {
    require_no_lease();
    if (open_job.load() != nullptr)
      throw Error(Status::kState, "A job of this model has begun and not finished: finish it or destroy it first.");
    return *simulation;
  }
  void require_no_lease() const {
    if (!leases.empty())
      throw Error(Status::kLeased,
                  std::to_string(leases.size()) + " views of this model are held: release them first.");
  }
};

struct ModelObject : Object {
  static constexpr ObjectKind kKind = ObjectKind::kModel;
  ModelObject() : Object(kKind) {}
  Gate& gate() noexcept override { return engine->gate; }
  std::shared_ptr<Engine> engine = std::make_shared<Engine>();
  std::atomic<bool> cancel{false};
};

struct JobObject : Object {
  static constexpr ObjectKind kKind = ObjectKind::kJob;
  explicit JobObject(std::shared_ptr<Engine> of_model) : Object(kKind), engine(std::move(of_model)) {}
  ~JobObject() override { end(); }
  std::shared_ptr<Engine> engine;  ///< before job: outlives it
  std::unique_ptr<Job> job;
  std::atomic<bool> cancel{false};  ///< asked for and not yet obeyed; outlives the pause between two slices

  /// From the first slice to the last the model is this job's.
  void begin() {
    engine->require_no_lease();
    const void* nobody = nullptr;
    if (!engine->open_job.compare_exchange_strong(nobody, this) && nobody != this)
      throw Error(Status::kState,
                  "Another job of this model has begun and not finished: finish or destroy that first.");
  }
  void end() noexcept {
    const void* me = this;
    engine->open_job.compare_exchange_strong(me, nullptr);
  }
};

struct StateObject : Object {
  static constexpr ObjectKind kKind = ObjectKind::kState;
  StateObject() : Object(kKind) {}
  std::weak_ptr<Engine> of;
  std::shared_ptr<SavedState> saved;
};

template <class Handle>
struct ObjectOf;
template <>
struct ObjectOf<vbgpd_context> {
  using Type = ContextObject;
};
template <>
struct ObjectOf<vbgpd_profile> {
  using Type = ProfileObject;
};
template <>
struct ObjectOf<vbgpd_model> {
  using Type = ModelObject;
};
template <>
struct ObjectOf<vbgpd_job> {
  using Type = JobObject;
};
template <>
struct ObjectOf<vbgpd_state> {
  using Type = StateObject;
};

}  // namespace vbgpd::capi
