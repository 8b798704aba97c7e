// Reading a state: particle and bond quantities by plain loops over the bonds, one lane at a time. No speed needed
// here.
#pragma once

#include <vector>

#include "state/model.h"

namespace vbgpd {

/// One bond (or, without bonds, one particle: i == j) with its present stress.
struct ObservedBond {
  std::int32_t i = 0, j = 0;                 ///< storage indices
  std::size_t record = 0;                    ///< index of its plastic xx in State::plastic_strain
  Real volume = 0;                           ///< B_ij, m2
  Real sxx = 0, syy = 0, sxy = 0, mean = 0;  ///< deviator and mean stress, Pa
  Real stored_mean = 0;                      ///< mean stress once what dilated has become volume of the ends, Pa
  Real shear_modulus = 0, bulk_modulus = 0;
  bool plastic = false;    ///< has ever yielded
  Real plastic_shear = 0;  ///< engineering plastic shear strain sqrt(2 e^p : e^p)
};

/// Calls f(ObservedBond) for every bond, in storage order of packs. `scratch` holds L and dilation of the present
/// displacements.
template <class F>
void for_each_bond(const Model& m, const State& s, const Scratch& scratch, const std::vector<LawConstants>& constants,
                   Real cohesion_scale, F&& f);

/// Particle averages sigma_i = sum_j w~ V_j sigma_ij / sum_j w~ V_j and the like, by storage index.
struct ParticleFields {
  std::vector<Real> xx, yy, zz, xy, plastic_strain, plastic_fraction;
};
ParticleFields particle_fields(const Model& m, const State& s, const Scratch& scratch,
                               const std::vector<LawConstants>& constants, Real cohesion_scale);

/// Elastic energy of all bonds, J per metre run: sum B_ij (J2/2G + m^2/2K), after the plastic flow of this instant:
/// what dilates is not taken out of the bond but of the particles at its ends.
Real elastic_energy(const Model& m, const State& s, const Scratch& scratch, const std::vector<LawConstants>& constants,
                    Real cohesion_scale);

/// Bonds with plastic strain.
std::int64_t plastic_bonds(const Model& m, const State& s);

}  // namespace vbgpd

#include "simulation/observe_impl.h"
