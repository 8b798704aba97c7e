// Every check on what the user says that needs no polygon arithmetic (that is geometry/check.h), in one place.
#pragma once

#include <vector>

#include "scene/scene_def.h"

namespace vbgpd {

/// All problems of a scene, errors and warnings, in the order the user wrote things. Empty = none.
/// Errors: missing, not finite or out of range values, unknown names, too few vertices. Warnings: implausible values,
/// each naming the unit slip that would explain it (unit weight 20 in SI is probably kN/m3; friction angle 0.35 is
/// probably radians).
std::vector<Issue> validate(const SceneDef& scene);

/// True when any issue is an error.
bool has_error(const std::vector<Issue>& issues);

}  // namespace vbgpd
