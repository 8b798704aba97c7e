// The loop of observe.h.
#pragma once

#include <array>
#include <cmath>

#include "material/cone.h"
#include "material/hexagon.h"

namespace vbgpd {

namespace observe_detail {

inline Returned<Real> returned(const LawConstants& c, ReturnAlgorithm algorithm, const Stress<Real>& trial) {
  static_assert(kReturnAlgorithms == 2, "what is no cone is a hexagon");
  return algorithm == ReturnAlgorithm::kCone ? return_to(Cone<Real>(c), trial) : return_to(Hexagon<Real>(c), trial);
}

/// Symmetric bond strain (VB2) or, for i == j, particle strain.
struct Strain {
  Real xx, yy, xy;
};
inline Strain strain(const State& s, const Scratch& l, const Offset& o, std::size_t i, std::size_t j) {
  const Real bxx = (l.gradient_xx[i] + l.gradient_xx[j]) / 2, bxy = (l.gradient_xy[i] + l.gradient_xy[j]) / 2;
  const Real byx = (l.gradient_yx[i] + l.gradient_yx[j]) / 2, byy = (l.gradient_yy[i] + l.gradient_yy[j]) / 2;
  if (i == j) return {bxx, byy, (bxy + byx) / 2};
  const Real cx = s.displacement_x[j] - s.displacement_x[i] - bxx * o.xi_x - bxy * o.xi_y;
  const Real cy = s.displacement_y[j] - s.displacement_y[i] - byx * o.xi_x - byy * o.xi_y;
  const Real nx = o.xi_x * o.inverse_r2, ny = o.xi_y * o.inverse_r2;
  return {bxx + cx * nx, byy + cy * ny, (bxy + byx + cx * ny + cy * nx) / 2};
}

/// Without its mean, as the records of plastic strain hold it: xx, yy, xy.
using Three = std::array<Real, 3>;
inline Three deviator(const Strain& e) {
  const Real third = (e.xx + e.yy) / 3;
  return {e.xx - third, e.yy - third, e.xy};
}

}  // namespace observe_detail

template <class F>
void for_each_bond(const Model& m, const State& s, const Scratch& scratch, const std::vector<LawConstants>& constants,
                   Real cohesion_scale, F&& f) {
  const auto w = static_cast<std::size_t>(m.width);
  const bool bonded = m.features.bond != BondLaw::kNone;
  for (const BondPack& p : m.packs)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(p.i + l), j = static_cast<std::size_t>(p.j + l);
      if (((p.lanes >> l) & 1) == 0 || m.seed_of[i] < 0 || m.seed_of[j] < 0) continue;
      const Offset o = m.offset(p, l);
      LawConstants c = constants[p.pair];
      if (m.extra_cohesion.present())
        c.k += (m.extra_cohesion[i] + m.extra_cohesion[j]) / 2 * cohesion_scale * c.k_per_cohesion;
      ObservedBond b;
      b.i = p.i + l, b.j = p.j + l;
      b.record = 3 * (bonded ? w * static_cast<std::size_t>(p.slot) : static_cast<std::size_t>(p.i)) +
                 static_cast<std::size_t>(l);
      b.volume = bonded ? o.weight * (m.volume[i] * m.share[j] + m.share[i] * m.volume[j]) : m.volume[i];
      b.shear_modulus = c.shear_modulus, b.bulk_modulus = c.bulk_modulus;
      Real pxx = 0, pyy = 0, pxy = 0;
      if (s.plastic_strain.present())
        pxx = s.plastic_strain[b.record], pyy = s.plastic_strain[b.record + w],
        pxy = s.plastic_strain[b.record + 2 * w];
      const observe_detail::Strain e = observe_detail::strain(s, scratch, o, i, j);
      const Real third = (e.xx + e.yy) / 3, twice = 2 * c.shear_modulus;
      const Stress<Real> trial{twice * (e.xx - third - pxx), twice * (e.yy - third - pyy), twice * (e.xy - pxy),
                               c.bulk_modulus * (scratch.dilation[i] + scratch.dilation[j]) / 2};
      const Stress<Real> r = observe_detail::returned(c, algorithm_of(m.pair_law[p.pair]), trial).stress;
      b.sxx = r.xx, b.syy = r.yy, b.sxy = r.xy, b.mean = r.m, b.stored_mean = trial.m;
      if (scratch.volume_source.present())
        b.stored_mean -=
            c.bulk_modulus / 2 * (scratch.volume_source[i] / m.volume[i] + scratch.volume_source[j] / m.volume[j]);
      if (s.placed_strain.present())
        pxx -= s.placed_strain[b.record], pyy -= s.placed_strain[b.record + w],
            pxy -= s.placed_strain[b.record + 2 * w];
      b.plastic = pxx != 0 || pyy != 0 || pxy != 0;
      const Real pzz = -(pxx + pyy);
      b.plastic_shear = std::sqrt(2 * (pxx * pxx + pyy * pyy + pzz * pzz + 2 * pxy * pxy));
      f(b);
    }
}

}  // namespace vbgpd
