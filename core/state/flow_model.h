// The run-out side of the engine (updated-Lagrangian): FlowModel is const after the hand-over but for the forces set
// from outside, FlowState is everything that changes, FlowLists follows from the state, FlowScratch is written before
// it is read.
#pragma once

#include <cstdint>
#include <vector>

#include "base/array.h"
#include "base/types.h"
#include "bond/bond_law.h"
#include "material/any_law.h"
#include "state/flow_records.h"

namespace vbgpd {

/// Numbers of the method (see core/README.md, "Run-out"). Lengths in particle spacings, the rest without dimension.
struct FlowOptions {
  Real bond_stiffness = 0.3;        ///< chi of soil: filters noise, decays with plastic flow
  Real elastic_bond_stiffness = 1;  ///< chi of a material that never yields: its bonds carry tension
  Real stress_diffusion = 0.08;     ///< zeta, in soil that yields or is disturbed
  Real disturbed = 0.01;            ///< plastic shear strain beyond which soil counts as disturbed
  Real guard_distance = 0.8;        ///< b: particles closer than b spacings repel each other
  Real guard_stiffness = 0.5;       ///< kappa, of K + 4G/3
  Real loose = 1.0 / 3;  ///< disturbed soil with less of sum V omega than that share of the bulk is a loose grain
  Real viscosity = 0.4;  ///< alpha c / sqrt(g H), on approach only
  Real viscosity_length = 1.3 / 20;  ///< h / H at which that viscosity is meant; held fixed when the spacing changes
  Real smallest_eigenvalue = 0.2;    ///< floor of the moment matrix, 1 in the bulk
  Real skin = 0.5;                   ///< how far beyond the support neighbours are listed
  Real time_step = 0.3;              ///< of spacing / wave speed
  Real friction_lag = 4;  ///< of height / wave speed: the while over which Coulomb walls take the mean normal force
  // of the rivals (sph, sph_artificial_stress, pseudo_spring, gpd)
  Real wave_viscosity = 0.1;        ///< alpha of Monaghan's alpha c h, c the wave speed, in soil (Bui et al. 2008)
  Real elastic_wave_viscosity = 1;  ///< where nothing yields (Gray, Monaghan & Swift 2001)
  Real artificial_stress = 0.3;     ///< eps (Gray, Monaghan & Swift 2001)
  Real spring_reach = 1.5;          ///< pseudo-springs join pairs nearer than that: the eight around a particle
};

struct FlowModel {
  Heap heap;  ///< where arrays and lists come from
  FlowOptions options;
  FlowBondLaw bond = FlowBondLaw::kVirtual;
  std::int64_t particles = 0;
  int materials = 0;
  Vec2 origin = Vec2::Zero();  ///< positions of the state are relative to it, m
  Real spacing = 0;            ///< geometric mean of the lattice, m
  Real support = 0;            ///< 2h, m
  Real height = 0, stress_scale = 0, stiffness = 0, force_scale = 0, gravity = 0;
  Real viscosity = 0;  ///< alpha c h, m2/s
  Real time_step = 0;  ///< s
  // by particle id
  Array volume, mass, reference_x, reference_y;
  Array force_x, force_y;  ///< all that pushes it from outside, N
  Array weight;            ///< N, without kv
  Array surface_area;      ///< present with loads: width of ground that is the particle's, m
  Array pore_pressure;     ///< present with water: Pa, compression positive; it goes with the particle
  Array size;              ///< of its guard: sqrt(volume), less where neighbours or walls are nearer from the start, m
  Array extra_cohesion;    ///< present with a cohesion gradient, Pa
  std::vector<std::int32_t> material;
  // by material
  std::vector<AnyLaw> law;
  std::vector<Strength> strength;  ///< unreduced
  std::vector<LawConstants> moduli;
  std::vector<FlowWall> walls;
  bool keeps_bonds() const { return bond == FlowBondLaw::kVirtual || bond == FlowBondLaw::kPseudoSpring; }
  std::size_t bytes() const;
};

/// Everything that changes. Particles are kept in the order of the last neighbour search; `for_each_array` is the ONE
/// list of the arrays.
struct FlowState {
  Array motion;          ///< [4n] x, y (m), v_x, v_y (m/s)
  Array stress;          ///< [4(n + 1)] deviator xx, yy, xy and mean stress, Pa; the last one is blank
  Array gap;             ///< volumetric strain by which a particle in tension has come apart
  Array plastic_strain;  ///< engineering plastic shear strain, summed along the way
  Array wall_shear;      ///< elastic stretch of the contact with a rough wall, m
  Array wall_limit;      ///< present with Coulomb walls: their friction at most, mean over a short while, N
  Array particle;        ///< id of the particle at this place of the order
  Array listed;          ///< [2n] positions at the last neighbour search
  Array dead;            ///< present with law gpd: 1 once the particle has reached its strength
  /// For each pack of the neighbour list, with a law that keeps bonds. virtual_bond: four x, four y of the traction,
  /// Pa; pseudo_spring: four rest lengths (m; 0 = never joined), four times 1 while whole, 0 once broken.
  Array traction;

  template <class S, class F>
  static void for_each_array(S& s, F&& f) {
    f("motion", s.motion);
    f("stress", s.stress);
    f("gap", s.gap);
    f("plastic_strain", s.plastic_strain);
    f("wall_shear", s.wall_shear);
    f("wall_limit", s.wall_limit);
    f("particle", s.particle);
    f("listed", s.listed);
    f("dead", s.dead);
    f("traction", s.traction);
  }
  void allocate(const FlowModel& m);
  std::size_t bytes() const;
  std::uint64_t hash() const;
};

/// What follows from FlowState::listed, and the constants of the particles in the present order.
struct FlowLists {
  std::vector<FlowRow> rows;
  List<std::int32_t> neighbours;  ///< four to a pack; soil below `particles`, the blank one, then ghosts
  std::vector<FlowGhost> ghosts;
  std::vector<std::int32_t> soil;   ///< material
  Array constants;                  ///< [4(n + 1)] volume (m2), mass (kg), K + 4G/3 (Pa), size (m)
  Array volume;                     ///< [n + 1 + ghosts]
  Array force;                      ///< [2n] weight, seismic force and loads, N
  Array extra_cohesion;             ///< Pa
  Array pore_pressure;              ///< Pa
  std::vector<std::int32_t> group;  ///< of each particle, then of each ghost: those of one cell
  std::vector<FlowTouch> touching;
  std::int32_t groups = 0;
  std::size_t bytes() const;
};

/// What a step writes before it reads it. [4 (n + 1 + ghosts)] unless said otherwise.
struct FlowScratch {
  Array motion, next_motion;  ///< motion with ghosts; of the next step
  Array next_stress;          ///< [4(n + 1)]
  Array gradient;             ///< L: xx, xy, yx, yy
  Array bond;                 ///< return ratio, 1/omega0, chi G, volume
  Array inverse;              ///< M^-1: xx, xy, yy; how many packs of soil reach into the support
  Array flux;                 ///< P = Z M^-1 / V: xx, xy, yx, yy
  Array slope_x, slope_y;     ///< gradient of the four stress components, with laws that diffuse them
  Array artificial;           ///< artificial stress xx, yy, xy, with the law that has it
  Array pair_force;           ///< [2n], with virtual bonds
  Array weight;               ///< [4(1 + ghosts)] share of the weight in the stress of the mirror images
  /// [16] for each pack of soil: V_j omega xi_x, V_j omega xi_y, V_j omega, 1/r; found once, used in three passes.
  Array pairs;
  std::size_t bytes() const;
};

}  // namespace vbgpd
