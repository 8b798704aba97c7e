// The list of bond laws: how two particles act on each other. Their passes over the bonds are in step/ (bonds.h,
// particles.h).
#pragma once

#include <optional>
#include <string_view>

namespace vbgpd {

enum class BondLaw : int {
  kNone = 0,      ///< "none": corrected nodal SPH, stress and yielding at the particle
  kSelective = 1  ///< "virtual_bond" (VB-S): deviator and yielding at the bond, volume at the particle
};

inline std::optional<BondLaw> bond_law_by_name(std::string_view name) {
  if (name == "none") return BondLaw::kNone;
  if (name == "virtual_bond") return BondLaw::kSelective;
  return std::nullopt;
}

/// Elastic modulus of a bond that joins two materials. Its strength: simulation/build_model.cpp, rule and measurement
/// in README.md.
inline double joined(double a, double b) { return 0.5 * (a + b); }

}  // namespace vbgpd
