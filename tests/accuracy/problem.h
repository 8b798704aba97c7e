// A problem with a known answer: what is asked of the engine, and how far it is off.
#pragma once

#include <span>

#include "scene/scene_def.h"

namespace vbgpd::accuracy {

/// What one run gave.
struct Outcome {
  double error = 0;  ///< as the problem defines it; NaN = no answer
  std::int64_t particles = 0, steps = 0;
  double bytes = 0;
};

struct Problem {
  const char* name;
  const char* error_kind;                                  ///< what `error` measures
  const char* reference;                                   ///< the known answer and where it comes from
  double height;                                           ///< m: the ladder is height / 5, / 10 ...
  int finest;                                              ///< last rung: height / finest
  Outcome (*run)(const SceneDef& choice, double spacing);  ///< `choice` carries bond law and kernel
};

std::span<const Problem> elastic_problems();
std::span<const Problem> limit_problems();

}  // namespace vbgpd::accuracy
