// Strength reduction of a scene from beginning to end.
#pragma once

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

}  // namespace vbgpd
