// What the four handles stand for. Children share what they need of their parents, so any order of destruction is
// right.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "analysis/job.h"
#include "handles.h"
#include "scene/scene_def.h"
#include "simulation/simulation.h"

namespace vbgpd::capi {

struct ContextObject : Object {
  static constexpr ObjectKind kKind = ObjectKind::kContext;
  ContextObject() : Object(kKind) {}
  int threads = 1;
  std::int64_t max_particles = 0;
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
  std::shared_ptr<Engine> engine;  ///< before job: outlives it
  std::unique_ptr<Job> job;
  std::atomic<bool> cancel{false};  ///< asked for and not yet obeyed; outlives the pause between two slices
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

}  // namespace vbgpd::capi
