// Model: everything that never changes after compile. State: everything that does. Scratch: what a step writes before
// it reads.
#pragma once

#include <cstdint>
#include <vector>

#include "base/array.h"
#include "base/types.h"
#include "bond/bond_law.h"
#include "geometry/section.h"
#include "material/any_law.h"
#include "state/records.h"

namespace vbgpd {

/// What the arrays of a state must hold; absent arrays have no bytes.
struct Features {
  BondLaw bond = BondLaw::kSelective;
  bool plastic = true;             ///< any law yields: plastic strain is stored
  bool volumetric_plastic = true;  ///< any law dilates or is capped in tension
  bool dilatant = false;           ///< any law dilates in shear
  bool cohesion_gradient = false;
  bool uneven_dilation = false;  ///< bonds dilate between soils of different bulk modulus
  bool placed = false;           ///< soil was placed when the section was deformed already
  bool has_algorithm[kReturnAlgorithms] = {true, true};
};

struct Model {
  Heap heap;  ///< where its arrays and lists come from, and those of its states
  // lattice, offsets
  int width = 4;                ///< lanes of a pack
  std::int64_t storage = 0;     ///< length of particle arrays, padding included
  std::vector<Offset> offsets;  ///< forward ones first, then the opposites
  int forward_offsets = 0;
  std::int32_t forward_packs = 0;  ///< neighbour packs at forward offsets
  // lists
  List<Block> blocks;
  List<NeighbourPack> neighbours;
  List<BondPack> packs;
  std::vector<Chunk> chunks;
  std::int64_t slots = 0;  ///< bond records of `width` lanes each
  std::vector<GuidedParticle> guided;
  Features features;
  // particle arrays [storage]
  Array volume;                           ///< m2; 0 in padding
  Array share;                            ///< V_i / omega0_i, m4; absent without bonds
  Array moment_xx, moment_xy, moment_yy;  ///< M_i^-1 of VB1, m-2... per particle
  Array sum_x, sum_y;                     ///< sum_j V_j omega_ij xi_ij, m (0 in the bulk)
  Array force_x, force_y;                 ///< external force: weight, seismic, surface loads, N
  Array free_x, free_y;                   ///< 1 where the particle may move, 0 where a wall holds it
  Array mass;                             ///< true mass, kg
  Array scaled_mass;      ///< mass of the quasi-static relaxation, proportional to the stiffness around the particle
  Array extra_cohesion;   ///< present with a cohesion gradient: Pa above the material's cohesion
  Array compressibility;  ///< present where bonds dilate between soils of different stiffness: 1/K, Pa-1
  // present where particles are off the lattice (scene's jitter); then offsets tell who may be near, no more
  Array place_x, place_y;  ///< of the particles, from the lattice's origin, m
  /// omega_ij [neighbour packs x width] by weight_record, 0 where a lane is no bond; single precision, the same for
  /// both ends, whose sums (moments, omega0) are made of these: operators stay exact for linear fields, forces balance
  List<float> pair_weight;
  List<std::int32_t> material;  ///< per storage index, -1 = padding
  // bookkeeping between seeds and storage
  List<std::int32_t> seed_of;     ///< storage -> seed, -1 = padding
  List<std::int32_t> storage_of;  ///< seed -> storage
  List<std::int32_t> id_of;       ///< seed -> particle id (soil first, then walls)
  // materials
  int materials = 0;
  std::vector<AnyLaw> pair_law;            ///< [materials x materials]
  std::vector<Strength> pair_strength;     ///< unreduced
  std::vector<LawConstants> pair_elastic;  ///< moduli only
  std::vector<bool> pair_grows;            ///< whether extra_cohesion counts for the pair; empty = no gradient
  // scales
  Real height = 0, stress_scale = 0, force_scale = 0,
       stiffness = 0;  ///< H, gamma H or q, sum |f_ext|, harmonic mean of Young's modulus over the soil
  std::int64_t particles = 0, soil_particles = 0, bonds = 0;
  bool off_lattice() const { return place_x.present(); }
  /// Geometry of lane l of a pack of bonds, or of neighbour pack k of a block.
  Offset offset(const BondPack& pack, int l) const;
  Offset offset(std::int32_t k, const Block& block, int l) const;
  /// Empty lists of the heap.
  void take_from(const Heap& heap);
  std::size_t bytes() const;
};

/// Everything that changes. `for_each_array` is the ONE list of its arrays: it serves memory count, hash and
/// clearing. What else knows them by name: core/README.md, "To add ...".
struct State {
  Array displacement_x, displacement_y;  ///< m
  Array velocity_x, velocity_y;          ///< m/s (relaxation: m per pseudo-time)
  Array plastic_volume;  ///< theta^p, plastic volumetric strain of a particle; absent when no law dilates
  Array gap;             ///< volumetric strain by which a particle in tension has come apart; absent likewise
  Array plastic_strain;  ///< [slots x 3 x width] (or particles) xx, yy, xy; absent when nothing yields
  Array placed_strain;   ///< the part of it that is the shape soil was placed in; absent when none was

  template <class S, class F>
  static void for_each_array(S& s, F&& f) {
    f("displacement_x", s.displacement_x);
    f("displacement_y", s.displacement_y);
    f("velocity_x", s.velocity_x);
    f("velocity_y", s.velocity_y);
    f("plastic_volume", s.plastic_volume);
    f("gap", s.gap);
    f("plastic_strain", s.plastic_strain);
    f("placed_strain", s.placed_strain);
  }
  void allocate(const Model& m);
  /// All but the plastic strain and what it was placed with, which are most of it.
  void take_motion(const State& other);
  std::size_t bytes() const;
  std::uint64_t hash() const;
};

/// What a step writes before it reads it: nothing to save.
struct Scratch {
  Array weighted_x, weighted_y;                              ///< V_i u_i, m3
  Array gradient_xx, gradient_xy, gradient_yx, gradient_yy;  ///< L_i (of the displacement, total form)
  Array dilation;                                            ///< elastic volumetric strain tr L_i - theta^p_i - gap_i
  Array flux_xx, flux_xy, flux_yx, flux_yy;                  ///< V_i S_i of VB5, then V_i S_i M_i^-1
  Array pair_force_x, pair_force_y;                          ///< sum of B_ij s_ij n_ij / r
  Array volume_source;       ///< volume that turned plastic in this step; absent when no law dilates in shear
  Array opening, mean_load;  ///< of the ledger, see keep_books: by how much the gap grew, V_i times mean stress
  void allocate(const Model& m);
  /// What the work of plastic volume takes, where the model has any; from the first step with a ledger on.
  void keep_books(const Model& m);
  std::size_t bytes() const;
};

}  // namespace vbgpd
