// Ground water of a scene: pressure in the pores below a water table or by r_u, the weight of saturated soil, and the
// thrust of water that stands on the ground.
#pragma once

#include <vector>

#include "geometry/section.h"
#include "state/model.h"

namespace vbgpd {

bool has_ground_water(const SceneDef& scene);
/// Does the water table run above the ground anywhere?
bool water_stands(const SceneDef& scene, const Section& section);

/// Elevation of the water table at x; minus infinity without one.
Real water_level(const SceneDef& scene, Real x);

/// Total unit weight of the soil at a place of the scene, N/m3.
Real unit_weight_at(const SceneDef& scene, Index material, const Vec2& place);

/// Pore pressure by particle id, Pa: hydrostatic below the water table, u = gamma_w (level - y); in soils with a pore
/// pressure ratio u = r_u sigma_v, sigma_v the weight of the column of cells above (Bishop & Morgenstern 1960). Empty
/// where the scene is dry.
std::vector<double> scene_pore_pressure(const SceneDef& scene, const Section& section);

/// Thrust of the water that stands on the ground, by storage index, N; absent when none does: its pressure at the
/// nearest point of the ground times the surface a particle has there.
struct StandingWater {
  Array x, y;
  StandingWater(const SceneDef& scene, const Section& section, const Model& m);
};

}  // namespace vbgpd
