// Strength reduction of a scene from beginning to end.
#pragma once

#include <gtest/gtest.h>

#include "analysis/job.h"

namespace vbgpd {

inline JobResult solve(const SceneDef& s, int levels, int threads = 1) {
  CompileOptions options;
  options.threads = threads;
  const auto simulation = Simulation::compile(s, options);
  const auto job = make_strength_reduction(*simulation);
  job->set("levels", levels);
  job->run(0, {});
  return job->result();
}

/// The same of a scene that must have an answer; levels 0 = 2, or as many as other options ask for.
inline JobResult solved(const SceneDef& s, int levels = 0) {
  const auto simulation = Simulation::compile(s, {});
  const auto job = make_strength_reduction(*simulation);
  job->set("levels", levels);
  EXPECT_EQ(job->run(0, {}), Status::kOk) << job->result().reason;
  return job->result();
}

}  // namespace vbgpd
