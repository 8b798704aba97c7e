// The arrays of one run-out step as plain pointers: what the instruction-set specific files see.
#pragma once

#include <cstdint>

#include "material/constants.h"
#include "state/flow_records.h"

namespace vbgpd {

/// A soil as the step sees it.
struct FlowLaw {
  LawConstants constants;
  int algorithm = 0;                ///< 0 cone, 1 hexagon
  double breaking_stretch = 1e300;  ///< of a pseudo-spring
  double loose = 0;                 ///< sum V omega below which a particle is a loose grain, m-2
};

/// What drives a run-out step: it changes between steps, never inside one.
struct FlowControls {
  double time_step = 0;
  double local_damping = 0;    ///< alpha of f_d = -alpha |f| sgn v: the value "damping", or that of a relaxation
  double inverse_support = 0;  ///< 1/(2h)
  double support2 = 0;         ///< (2h)^2
  double weight_scale = 0;     ///< 35 / (4 pi h^4)
  double softening = 0;        ///< 0.01 h^2
  double viscosity = 0;        ///< alpha c h, m2/s
  double guard_distance = 0;   ///< b, in sides of particles
  double guard_stiffness = 0;  ///< kappa
  double guard_reach = 0;      ///< b times the largest side: pairs farther apart do not feel it, m
  double diffusion = 0;        ///< 2 zeta h, m
  double disturbed = 0;        ///< plastic shear strain beyond which soil goes on diffusing its stress
  double smallest_eigenvalue = 0;
  double dashpot = 0;                    ///< 0.2 dx: of the contact with a wall, times rho c
  double spring_reach = 0;               ///< pseudo-springs join pairs nearer than that, m
  double artificial_stress = 0;          ///< eps
  double inverse_kernel_at_spacing = 0;  ///< 1 / ((1 - q/2)^4 (1 + 2q)), q = dx/h
  double image_reach = 0;                ///< mirror images farther away than that are not seen, m
  double friction_rate = 0;              ///< how much of a change of the normal force on a Coulomb wall a step takes in
  int walls_hold = 0;                    ///< 1: Coulomb walls hold whatever comes, while strengths are left out
  double cohesion_scale = 1;             ///< 1/F, for cohesion that grows with depth
  const FlowLaw* laws = nullptr;
};

/// Sums of one step, combined in chunk order. Works in J per metre run.
struct FlowSums {
  double unbalanced = 0, kinetic = 0, velocity2 = 0;
  double external = 0;              ///< done by weight, seismic force, loads and pore water
  double internal = 0;              ///< taken up by the stress of the particles
  double bond = 0;                  ///< taken up by bond tractions, or by the artificial stress
  double viscous = 0, damping = 0;  ///< dissipated
  double contact = 0;               ///< taken up by the contact with walls, friction included
  double wall = 0;                  ///< done by the weight term of the mirrored stress
  double guard = 0;                 ///< stored in the short-range guard, present value
  double yielding = 0;              ///< volume that yields now, m2

  void add(const FlowSums& s) {
    unbalanced += s.unbalanced, kinetic += s.kinetic, external += s.external, internal += s.internal, bond += s.bond;
    viscous += s.viscous, damping += s.damping, contact += s.contact, wall += s.wall, guard += s.guard;
    yielding += s.yielding;
    velocity2 = s.velocity2 > velocity2 ? s.velocity2 : velocity2;
  }
};

struct FlowData {
  int particles, ghost_count, wall_count, chunk;  ///< chunk: particles a thread takes at a time
  // lists
  const FlowRow* rows;
  const std::int32_t* neighbours;
  const FlowGhost* ghosts;
  const FlowWall* walls;
  const std::int32_t* soil;
  const double *constants, *volume, *force, *extra_cohesion, *pore_pressure;
  // state
  double *stress, *gap, *plastic_strain, *wall_shear, *wall_limit, *traction, *dead;
  // scratch; motion is the state's, with ghosts
  double *motion, *next_motion, *next_stress, *gradient, *bond, *inverse, *flux, *slope_x, *slope_y, *pair_force,
      *weight, *artificial, *pairs;
};

}  // namespace vbgpd
