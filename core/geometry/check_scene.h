// The checks that compare the parts of a scene with each other; no exact predicates needed.
#pragma once

#include <vector>

#include "scene/scene_def.h"

namespace vbgpd {

/// "layers[2] 'weak band'"
std::string layer_title(const SceneDef& scene, std::size_t layer);

/// Layers outside the exterior, painted over, soil left bare. `sound[k]`: polygon k has no fault of its own; faulty
/// ones are left out, and then nothing is said about bare soil and painting over. Needs a sound exterior.
void check_layers(const SceneDef& scene, const std::vector<bool>& sound, std::vector<Issue>& issues);

/// Points of boundary polylines that do not lie on the exterior.
void check_boundaries(const SceneDef& scene, std::vector<Issue>& issues);

/// Loads that do not lie on the ground surface.
void check_loads(const SceneDef& scene, std::vector<Issue>& issues);

/// Warns of loads that stand on each other: from left to right, each against the one before it that reaches farthest.
void check_overlapping_loads(const SceneDef& scene, std::vector<Issue>& issues);

/// Warns where the water table stands above the ground and is not level there.
void check_standing_water(const SceneDef& scene, std::vector<Issue>& issues);

}  // namespace vbgpd
