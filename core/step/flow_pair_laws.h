// How two particles of a run-out act on each other: each law answers a few questions, and the passes of the step are
// built once for each. What a law adds of its own is in the functions below. All of them move the same particles with
// the same kernel, soil laws, walls and time step.
#pragma once

#include "step/flow_weight.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// VB-H as described in core/README.md.
struct VirtualBonds {
  static constexpr bool kCorrected = true;  ///< gradients by the inverse moment matrix, else plain sums
  static constexpr bool kBonds = true;      ///< hourglass virtual bonds carry a traction
  static constexpr bool kGapMemory = true;  ///< what came apart in tension closes before it carries pressure
  static constexpr bool kGuard = true;      ///< particles too close repel each other
  static constexpr bool kGrains = true;     ///< what has hardly a neighbour left carries no stress
  static constexpr bool kArtificialStress = false;
  static constexpr bool kSprings = false;  ///< only pairs joined from the start act on each other
  static constexpr bool kDies = false;     ///< a particle that reaches its strength loses it
};

/// The same without the bonds.
struct CorrectedSph : VirtualBonds {
  static constexpr bool kBonds = false;
};

/// Libersky & Petschek (1991): a_i = sum m_j (sigma_i/rho_i^2 + sigma_j/rho_j^2) grad W, L_i = sum m_j/rho_j (v_j -
/// v_i) (x) grad W, with the density at the release: soil changes its volume by far less than the sums err.
struct PlainSph {
  static constexpr bool kCorrected = false, kBonds = false, kGapMemory = false, kGuard = false, kGrains = false;
  static constexpr bool kArtificialStress = false, kSprings = false, kDies = false;
};

/// Gray, Monaghan & Swift (2001): pairs in tension repel each other the more the closer they are.
struct ArtificialStress : PlainSph {
  static constexpr bool kArtificialStress = true;
};

/// Chakraborty & Shaw (2013): springs join immediate neighbours at the release and break when stretched too far. The
/// sums over so few neighbours need the moment matrix. The particles do not yield; particles that touch repel each
/// other, joined or not.
struct PseudoSprings {
  static constexpr bool kCorrected = true, kBonds = false, kGapMemory = false, kGuard = true, kGrains = false;
  static constexpr bool kArtificialStress = false, kSprings = true, kDies = false;
};

/// Zhou, Bi & Qian (2015): a particle whose stress reaches the strength is dead and carries neither shear nor tension.
/// It keeps its pressure: without it the rubble would fall through itself.
struct LifeAndDeath : PlainSph {
  static constexpr bool kDies = true;
};

/// eps sigma of the principal stresses in tension, with the sign of a repulsion: R = -eps max(sigma_k, 0) n_k (x) n_k.
/// stress: deviator xx, yy, xy and mean; out: xx, yy, xy.
VBGPD_INLINE void artificial_stress(double factor, const double* stress, double* out) {
  const double middle = 0.5 * (stress[0] + stress[1]) + stress[3], half = 0.5 * (stress[0] - stress[1]);
  const double radius = root(half * half + stress[2] * stress[2]);
  const double large = larger(middle + radius, 0), small = larger(middle - radius, 0);
  const double p = -0.5 * factor * (large + small), q = -0.5 * factor * (large - small);
  const double scale = radius > 0 ? q / radius : 0;
  out[0] = p + scale * half, out[1] = p - scale * half, out[2] = scale * stress[2], out[3] = 0;
}

/// (W(r) / W(dx))^4 of Wendland C2.
VBGPD_INLINE Pack closeness(const FlowControls& c, Pack r) {
  const Pack s = larger(1.0 - r * c.inverse_support, Pack{}), s2 = s * s;
  const Pack ratio = c.inverse_kernel_at_spacing * s2 * s2 * (5.0 - 4.0 * s), square = ratio * ratio;
  return square * square;
}

/// Springs of four pairs: rest lengths, m (0 = never joined), then 1 while whole and 0 once broken. Breaks those
/// stretched beyond what the weaker end bears; answers which are whole.
VBGPD_INLINE auto stretch_springs(double* record, Pack r, Pack breaking) {
  const Pack rest = load(record), whole = load(record + 4);
  const auto holds = (whole > Pack{}) & (r - rest <= breaking * rest);
  store(record + 4, select(holds, Pack{} + 1.0, Pack{}));
  return holds;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
