// Cohesion that grows with depth, across the places where two soils meet.
#pragma once

#include <vector>

#include "geometry/section.h"
#include "scene/scene_def.h"

namespace vbgpd {

/// Pa above the soil's own cohesion at height y, m.
Real extra_cohesion(const MaterialDef& material, Real y);

bool has_cohesion_gradient(const SceneDef& scene);

/// Mean height, m, of the pairs of cells through which two soils meet within the support, by pair of materials (the
/// lesser index first); NaN where they do not meet.
std::vector<Real> meeting_heights(const SceneDef& scene, const Section& section);

/// By seed: what the soil's own cohesion grows by there. A soil without a gradient takes what the soils around it have,
/// so that the mean over a bond is that of the soil with one; whether that counts is a matter of the pair
/// (Model::pair_grows).
std::vector<Real> extra_cohesion_of_seeds(const SceneDef& scene, const Section& section);

}  // namespace vbgpd
