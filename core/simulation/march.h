// Towards a time in steps of equal length: the same for every kind of simulation.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/types.h"
#include "scene/wording.h"

namespace vbgpd {

struct StepLength {
  Real time_step;
  bool last;  ///< ends exactly at the goal
};

/// A function of the present time alone, so that interruptions change no bit. An infinite goal: the longest step.
inline StepLength step_towards(Real goal, Real time, Real longest) {
  const Real left = goal - time;
  if (!std::isfinite(left)) return {longest, false};
  const Real parts = std::max<Real>(1, std::ceil(left / longest * (1 - 1e-12)));
  return {left / parts, parts == 1};
}

inline void require_ahead(double time, Real now) {
  if (time >= now && std::isfinite(time)) return;
  Issue issue;
  issue.status = Status::kRange, issue.object = ObjectKind::kModel, issue.value = time;
  issue.text = "cannot advance to " + number_text(time) + " s: the model is at " + number_text(now) + " s";
  throw Error(issue);
}

}  // namespace vbgpd
