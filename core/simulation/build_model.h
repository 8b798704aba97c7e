// Section + materials -> Model: lattice packs, operators (VB1), masses, external forces.
#pragma once

#include "geometry/section.h"
#include "scene/scene_def.h"
#include "simulation/simulation.h"
#include "state/model.h"

namespace vbgpd {

/// `width` lanes per pack. The scene is valid (validate, check_geometry).
Model build_model(const SceneDef& scene, const Section& section, int width, const Heap& heap = {});

/// What drives the soil as the scene says.
Drive scene_drive(const SceneDef& scene, const Section& section);
/// Weights, seismic forces, surface loads and wall velocities of the model, anew.
void apply_drive(const SceneDef& scene, const Section& section, const Drive& drive, Model& m);
/// m.force_scale from the forces as they are.
void measure_forces(Model& m);

/// Cohesion a frictional soil has at least, Pa: the surface layer of a cohesionless soil has no confinement of its own,
/// and a single particle would roll off at any factor. A share of one layer's weight; it vanishes with the spacing, and
/// the extrapolation over two grids takes it out at first order.
Real least_cohesion(const MaterialDef& material, Real spacing);

/// Index reach of the support in lattice cells: how many wall cells a boundary needs.
int support_reach(const SceneDef& scene);

/// Material constants of every pair at strength reduction factor F; `elastic` leaves the strengths out.
std::vector<LawConstants> pair_constants(const Model& model, Real factor, bool elastic);

}  // namespace vbgpd
