#include "simulation/observe.h"

namespace vbgpd {

ParticleFields particle_fields(const Model& m, const State& s, const Scratch& scratch,
                               const std::vector<LawConstants>& constants, Real cohesion_scale) {
  const auto n = static_cast<std::size_t>(m.storage);
  ParticleFields out;
  std::vector<Real> weight(n, 0);
  for (auto* v : {&out.xx, &out.yy, &out.zz, &out.xy, &out.plastic_strain, &out.plastic_fraction}) v->assign(n, 0);
  const auto add = [&](std::size_t i, const ObservedBond& b) {
    weight[i] += b.volume;
    out.xx[i] += b.volume * (b.sxx + b.mean), out.yy[i] += b.volume * (b.syy + b.mean);
    out.zz[i] += b.volume * (b.mean - b.sxx - b.syy), out.xy[i] += b.volume * b.sxy;
    out.plastic_strain[i] += b.volume * b.plastic_shear;
    out.plastic_fraction[i] += b.plastic ? b.volume : 0;
  };
  for_each_bond(m, s, scratch, constants, cohesion_scale, [&](const ObservedBond& b) {
    add(static_cast<std::size_t>(b.i), b);
    if (b.i != b.j) add(static_cast<std::size_t>(b.j), b);
  });
  for (std::size_t i = 0; i < n; ++i) {
    if (!(weight[i] > 0)) continue;
    for (auto* v : {&out.xx, &out.yy, &out.zz, &out.xy, &out.plastic_strain, &out.plastic_fraction})
      (*v)[i] /= weight[i];
  }
  return out;
}

Real elastic_energy(const Model& m, const State& s, const Scratch& scratch, const std::vector<LawConstants>& constants,
                    Real cohesion_scale) {
  Real sum = 0;
  for_each_bond(m, s, scratch, constants, cohesion_scale, [&](const ObservedBond& b) {
    const Real j2 = b.sxx * b.sxx + b.syy * b.syy + b.sxx * b.syy + b.sxy * b.sxy;
    sum += b.volume * (j2 / (2 * b.shear_modulus) + b.stored_mean * b.stored_mean / (2 * b.bulk_modulus));
  });
  return sum;
}

std::int64_t plastic_bonds(const Model& m, const State& s) {
  if (!s.plastic_strain.present()) return 0;
  const auto w = static_cast<std::size_t>(m.width);
  const bool bonded = m.features.bond != BondLaw::kNone;
  std::int64_t count = 0;
  for (const BondPack& p : m.packs)
    for (int l = 0; l < m.width; ++l) {
      const auto i = static_cast<std::size_t>(p.i + l), j = static_cast<std::size_t>(p.j + l);
      if (((p.lanes >> l) & 1) == 0 || m.seed_of[i] < 0 || m.seed_of[j] < 0) continue;
      const std::size_t r = 3 * (bonded ? w * static_cast<std::size_t>(p.slot) : static_cast<std::size_t>(p.i)) +
                            static_cast<std::size_t>(l);
      const bool placed = s.placed_strain.present();
      const auto yielded = [&](std::size_t k) { return s.plastic_strain[k] != (placed ? s.placed_strain[k] : 0); };
      if (yielded(r) || yielded(r + w) || yielded(r + 2 * w)) ++count;
    }
  return count;
}

}  // namespace vbgpd
