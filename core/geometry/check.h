// Exact checks of the profile polygons; the exact part is geometry/predicates.h.
#pragma once

#include <vector>

#include "scene/scene_def.h"

namespace vbgpd {

/// Every geometric fault of a scene, found with exact predicates on the coordinates as given: exterior or layer not
/// simple (which edges cross, where), repeated or collinear-degenerate vertices, zero area, layer wholly outside the
/// exterior, boundary polyline that touches nothing, load off the ground surface, soil left without a material.
/// Warnings: a layer partly outside, a layer wholly painted over.
std::vector<Issue> check_geometry(const SceneDef& scene);

/// Everything that is wrong with a scene: validate() and check_geometry(), without saying one fault twice. Where
/// nothing is, a warning for every soil too thin for the scene's spacing.
std::vector<Issue> all_issues(const SceneDef& scene);

}  // namespace vbgpd
