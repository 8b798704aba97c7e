// The list of bond laws: how two particles act on each other. Their passes are in step/: bonds.h and particles.h at
// small displacements, flow_pair_laws.h in a run-out.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace vbgpd {

/// At small displacements (total-Lagrangian).
enum class BondLaw : int {
  kNone = 0,      ///< corrected nodal SPH, stress and yielding at the particle
  kSelective = 1  ///< VB-S: deviator and yielding at the bond, volume at the particle
};

/// In a run-out (updated-Lagrangian). The last four are the methods that the introduction of Zhang & Zhou (2018) sets
/// VB-GPD against; they are there to be compared with.
enum class FlowBondLaw : int {
  kVirtual = 0,       ///< VB-H: hourglass virtual bonds on top of the stress of the particles
  kNone,              ///< VB-H without its bonds
  kSph,               ///< plain SPH (Libersky & Petschek 1991) with Monaghan's artificial viscosity
  kArtificialStress,  ///< that with the artificial stress of Gray, Monaghan & Swift (2001)
  kPseudoSpring,      ///< immediate neighbours joined by springs that break in tension (Chakraborty & Shaw 2013)
  kGpd                ///< plain SPH whose particles die where they reach their strength (Zhou et al. 2015)
};

/// What a scene calls a law, and what it is on either side of the engine.
struct BondLawName {
  std::string_view name;
  BondLaw at_rest;
  FlowBondLaw in_runout;
};
inline constexpr std::array<BondLawName, 6> kBondLaws{
    {{"virtual_bond", BondLaw::kSelective, FlowBondLaw::kVirtual},
     {"none", BondLaw::kNone, FlowBondLaw::kNone},
     {"sph", BondLaw::kNone, FlowBondLaw::kSph},
     {"sph_artificial_stress", BondLaw::kNone, FlowBondLaw::kArtificialStress},
     {"pseudo_spring", BondLaw::kNone, FlowBondLaw::kPseudoSpring},
     {"gpd", BondLaw::kNone, FlowBondLaw::kGpd}}};

inline std::optional<BondLawName> bond_law_by_name(std::string_view name) {
  for (const BondLawName& law : kBondLaws)
    if (law.name == name) return law;
  return std::nullopt;
}

/// Elastic modulus of a bond that joins two materials: springs in series, as stress is continuous across the joint. Its
/// strength: simulation/build_model.cpp, rules and measurements in README.md.
inline double joined(double a, double b) { return a == b ? a : 2 * a * b / (a + b); }

}  // namespace vbgpd
