// Vertical strip loads on the ground surface.
#pragma once

#include <functional>

#include "geometry/section.h"
#include "scene/scene_def.h"
#include "state/model.h"

namespace vbgpd {

/// Vertical component of the discrete normal area a_i n_i of every particle, by storage index.
std::vector<Real> normal_areas(const Model& m);

/// Spreads the loads over the soil: calls push(seed, force in y) for every particle near the surface under a load;
/// `area` gives the normal area of a seed.
void spread_surface_loads(const std::vector<LoadDef>& loads, const Section& section, Real smoothing_ratio,
                          const std::function<Real(std::size_t)>& area,
                          const std::function<void(std::size_t, Real)>& push);

/// Adds the loads to m.force_y through the discrete normal of the operators:
///   f_i = -q a_i n_i,  a_i n_i = -sum_j (V_i Phi_ij - V_j Phi_ji)
/// on all rows near the surface where it is not zero, scaled so that each load's total on the soil is exact. Upright
/// rollers get the image of what loads the soil beside them.
void add_surface_loads(const std::vector<LoadDef>& loads, const Section& section, Real smoothing_ratio, Model& m);

}  // namespace vbgpd
