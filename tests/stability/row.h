// A row of the table of stiff and extreme cases: a scene, what must come of it, and what came.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/scene_def.h"

namespace vbgpd::stability {

/// What a case came to. NaN = has no such number.
struct Outcome {
  std::string verdict;  ///< a status of a job, "at rest", "diverged", "refused" ...
  double factor_of_safety = kNone;
  double deviation = kNone;        ///< of FS from what it must be, relative
  double energy_residual = kNone;  ///< relative to the largest energy or work of the run
  double momentum_drift = kNone;   ///< relative
  double steps = kNone;
  std::string note;
};

struct Case {
  std::string name;
  std::string expected;                                                      ///< verdict
  double most_deviation = kNone, most_residual = kNone, most_drift = kNone;  ///< NaN = not asked
  bool fast = false;  ///< belongs to the subset of every test run
  std::function<Outcome()> run;
  std::string known = {};          ///< why numbers are not as they must be, where that is known (README)
  std::string known_verdict = {};  ///< and which verdict comes instead of the expected one
};

std::vector<Case> strength_cases();
std::vector<Case> dynamic_cases();

/// Griffiths & Lane's example 1, H = 10 spacings: every variation is compared with it.
SceneDef base_slope();

}  // namespace vbgpd::stability
