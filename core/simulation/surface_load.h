// Vertical strip loads on the ground surface.
#pragma once

#include "scene/scene_def.h"
#include "state/model.h"

namespace vbgpd {

/// Adds the loads to m.force_y through the discrete normal of the operators (method 4.12):
///   f_i = -q a_i n_i,  a_i n_i = -sum_j (V_i Phi_ij - V_j Phi_ji)
/// on all rows near the surface where it is not zero, scaled so that each load's total is exact.
void add_surface_loads(const std::vector<LoadDef>& loads, const Section& section, Model& m);

}  // namespace vbgpd
