// Section + materials -> Model: lattice packs, operators (VB1), masses, external forces.
#pragma once

#include "geometry/section.h"
#include "scene/scene_def.h"
#include "state/model.h"

namespace vbgpd {

/// `width` lanes per pack. The scene is valid (validate, check_geometry).
Model build_model(const SceneDef& scene, const Section& section, int width);

/// Index reach of the support in lattice cells: how many wall cells a boundary needs.
int support_reach(const SceneDef& scene);

/// Material constants of every pair at strength reduction factor F; `elastic` leaves the strengths out.
std::vector<LawConstants> pair_constants(const Model& model, Real factor, bool elastic);

}  // namespace vbgpd
