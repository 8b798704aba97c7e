// Soil laws: what a material's parameters mean. Each law says which return algorithm it uses and derives that
// algorithm's constants. To add one: core/README.md, "To add ...".
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "material/constants.h"

namespace vbgpd {

inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

/// Linear elasticity: never yields.
struct Elastic {
  static constexpr std::string_view name = "elastic";
  static constexpr ReturnAlgorithm algorithm = ReturnAlgorithm::kCone;
  static constexpr bool yields = false;
  static constexpr int generality = 0;
  static void derive(const Strength&, LawConstants&) {}
};

/// Drucker-Prager with the constants that match Mohr-Coulomb in plane strain for the dilatancy angle at hand:
///   alpha_psi = sin psi / sqrt(9 + 3 sin^2 psi),  D = sqrt(1 - 3 alpha_psi^2) + alpha_psi sin phi,
///   alpha_phi = sin phi / (3 D),  k = c cos phi / D.
/// psi = phi gives the classical associated match, psi = 0 gives alpha = sin phi / 3, k = c cos phi.
struct DruckerPrager {
  static constexpr std::string_view name = "drucker_prager";
  static constexpr ReturnAlgorithm algorithm = ReturnAlgorithm::kCone;
  static constexpr bool yields = true;
  static constexpr int generality = 2;
  static void derive(const Strength& s, LawConstants& c) {
    const Real sin_phi = std::sin(s.friction_angle), sin_psi = std::sin(s.dilatancy_angle);
    const Real alpha_psi = sin_psi / std::sqrt(9 + 3 * sin_psi * sin_psi);
    const Real match = std::sqrt(1 - 3 * alpha_psi * alpha_psi) + alpha_psi * sin_phi;
    c.a = sin_phi / match;
    c.k_per_cohesion = std::cos(s.friction_angle) / match;
    c.k = s.cohesion * c.k_per_cohesion;
    c.b = 3 * alpha_psi;
    const Real apex = c.a > 0 ? c.k / c.a : kInfinity;
    c.t = std::min(s.tension_cutoff, apex);
  }
};

/// Mohr-Coulomb hexagon, f = (s1 - s3) + (s1 + s3) sin phi - 2 c cos phi, flow with psi.
struct MohrCoulomb {
  static constexpr std::string_view name = "mohr_coulomb";
  static constexpr ReturnAlgorithm algorithm = ReturnAlgorithm::kHexagon;
  static constexpr bool yields = true;
  static constexpr int generality = 3;
  static void derive(const Strength& s, LawConstants& c) {
    c.a = std::sin(s.friction_angle);
    c.k_per_cohesion = 2 * std::cos(s.friction_angle);
    c.k = s.cohesion * c.k_per_cohesion;
    c.b = std::sin(s.dilatancy_angle);
    const Real apex = c.a > 0 ? c.k / (2 * c.a) : kInfinity;
    c.t = std::min(s.tension_cutoff, apex);
  }
};

/// Undrained clay, phi = 0: sqrt(J2) = c, isochoric; the cone's plane-strain match of Tresca. Cohesion may grow with
/// depth.
struct Undrained {
  static constexpr std::string_view name = "undrained";
  static constexpr ReturnAlgorithm algorithm = ReturnAlgorithm::kCone;
  static constexpr bool yields = true;
  static constexpr int generality = 1;
  static void derive(const Strength& s, LawConstants& c) {
    c.k_per_cohesion = 1;
    c.k = s.cohesion;
    c.t = s.tension_cutoff;
  }
};

}  // namespace vbgpd
