// The list of soil laws, by name.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "material/laws.h"

namespace vbgpd {

using AnyLaw = std::variant<Elastic, DruckerPrager, MohrCoulomb, Undrained>;

/// The law of that name, or nothing.
inline std::optional<AnyLaw> law_by_name(std::string_view name) {
  std::optional<AnyLaw> found;
  auto look = [&]<class... L>(std::variant<L...>*) { ((L::name == name ? (void)(found = L{}) : void()), ...); };
  look(static_cast<AnyLaw*>(nullptr));
  return found;
}

inline ReturnAlgorithm algorithm_of(const AnyLaw& law) {
  return std::visit(
      [](auto l) {
        static_assert(static_cast<int>(decltype(l)::algorithm) < kReturnAlgorithms);
        return decltype(l)::algorithm;
      },
      law);
}
/// Elastic < undrained < Drucker-Prager < Mohr-Coulomb: a law can represent the strengths of those below it.
inline int generality(const AnyLaw& law) {
  return std::visit([](auto l) { return decltype(l)::generality; }, law);
}
inline bool yields(const AnyLaw& law) {
  return std::visit([](auto l) { return decltype(l)::yields; }, law);
}

/// Poisson's ratio that the bulk modulus is taken with. The mean stress of a nearly incompressible body is noise
/// (measured: 2, 4, 7 % of gamma H at 0.49, 0.499, 0.4999), which a strength that depends on it would feel: it is
/// limited to that of 0.49 in soils with friction or a tension cut-off. Factors of safety do not depend on elastic
/// constants.
inline constexpr Real kLargestPoissonRatio = 0.49;
inline Real effective_poisson_ratio(const AnyLaw& law, Real poisson_ratio, const Strength& strength) {
  const bool feels_pressure = yields(law) && (strength.friction_angle > 0 || std::isfinite(strength.tension_cutoff));
  return feels_pressure ? std::min(poisson_ratio, kLargestPoissonRatio) : poisson_ratio;
}

/// Elastic moduli from Young's modulus and Poisson's ratio, and the law's strength constants.
inline LawConstants derive(const AnyLaw& law, Real young_modulus, Real poisson_ratio, const Strength& strength) {
  LawConstants c;
  c.shear_modulus = young_modulus / (2 * (1 + poisson_ratio));
  c.bulk_modulus = young_modulus / (3 * (1 - 2 * poisson_ratio));
  std::visit([&](auto l) { decltype(l)::derive(strength, c); }, law);
  return c;
}

/// Strength reduced by F: c/F, atan(tan phi / F), psi not above phi, tension cut-off/F.
inline Strength reduced(const Strength& s, Real factor) {
  Strength r;
  r.cohesion = s.cohesion / factor;
  r.friction_angle = std::atan(std::tan(s.friction_angle) / factor);
  r.dilatancy_angle = std::min(s.dilatancy_angle, r.friction_angle);
  r.tension_cutoff = s.tension_cutoff / factor;
  return r;
}

}  // namespace vbgpd
