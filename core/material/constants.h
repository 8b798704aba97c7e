// The numbers a law works with, derived once per material (or pair of materials) and strength reduction factor.
#pragma once

#include <limits>

#include "base/real.h"

namespace vbgpd {

/// Strength of a soil at the present strength reduction factor; angles in radians.
struct Strength {
  Real cohesion = 0;                                            ///< Pa
  Real friction_angle = 0;                                      ///< rad
  Real dilatancy_angle = 0;                                     ///< rad, <= friction_angle
  Real tension_cutoff = std::numeric_limits<Real>::infinity();  ///< Pa; infinity = the apex decides
};

/// How a law returns its stress to the yield surface: cone.h, hexagon.h.
enum class ReturnAlgorithm : int { kCone = 0, kHexagon = 1 };
inline constexpr int kReturnAlgorithms = 2;

/// Constants of one law for one material: elastic moduli and four numbers whose meaning the law defines.
struct LawConstants {
  Real shear_modulus = 0, bulk_modulus = 0;        ///< Pa
  Real a = 0;                                      ///< cone: 3 alpha_phi          Mohr-Coulomb: sin phi
  Real k = std::numeric_limits<Real>::infinity();  ///< cone: k_c, Pa   Mohr-Coulomb: 2 c cos phi, Pa
  Real b = 0;                                      ///< cone: 3 alpha_psi          Mohr-Coulomb: sin psi
  Real t = std::numeric_limits<Real>::infinity();  ///< cone: largest mean stress, Pa   Mohr-Coulomb: largest principal
                                                   ///< stress, Pa
  Real k_per_cohesion = 0;                         ///< dk / dc: what a pascal of extra cohesion adds to k
};

}  // namespace vbgpd
