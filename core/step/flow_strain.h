// First pass of a run-out step: operators, velocity gradient and forces on approach at the present positions, then the
// stress.
#pragma once

#include "step/flow_approach.h"
#include "step/flow_pair_laws.h"
#include "step/flow_stress.h"
#include "step/flow_water.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

inline constexpr double kJustBelowOne = 1 - 0x1p-53;

/// Sums over the neighbours of one particle: M = sum_j V_j omega_ij xi xi^T, sum_j V_j omega_ij, sum_j V_j omega_ij
/// (v_j - v_i) (x) xi.
struct FlowStrainSums {
  Pack mxx{}, mxy{}, myy{}, total{}, axx{}, axy{}, ayx{}, ayy{};
  FlowApproach approach;
  VBGPD_INLINE void add(Pack weight, Pack wx, Pack wy, Pack x, Pack y, Pack vx, Pack vy) {
    total += weight;
    mxx += wx * x, mxy += wx * y, myy += wy * y;
    axx += vx * wx, axy += vx * wy, ayx += vy * wx, ayy += vy * wy;
  }
};

/// Four soil neighbours of particle i; answers whether one of them is within the support.
template <class PairLaw>
VBGPD_INLINE bool add_soil_strain(const FlowData& d, const FlowControls& c, int i, std::int32_t p, FlowStrainSums& s) {
  const std::int32_t* const j = d.neighbours + 4l * p;
  const Quads own = broadcast_quad(d.motion + 4l * i), other = load_quads(d.motion, j);
  const Pack x = other.a - own.a, y = other.b - own.b, r2 = x * x + y * y;
  const bool near = any(r2 < c.support2);
  double* const pair = d.pairs + 16l * p;
  if (!PairLaw::kSprings && !near) {
    for (int k = 0; k < 16; k += 4) store(pair + k, Pack{});
    return false;
  }
  const Pack r = root(r2), weight = pair_weight(c, r);
  const FirstTwo end = load_first_two(d.constants, j);
  const double* const self = d.constants + 4l * i;
  const Pack vx = other.c - own.c, vy = other.d - own.d;
  add_viscosity(c, x, y, r2, vx, vy, weight, 0.5 * (self[1] * end.a + self[0] * end.b), s.approach);
  if constexpr (PairLaw::kGuard) add_guard(c, x, y, r, d.constants, i, j, s.approach);
  Pack joined = weight * end.a;
  if constexpr (PairLaw::kSprings) {
    const double own_stretch = c.laws[d.soil[i]].breaking_stretch;
    const auto bears = [&](int k) {
      return j[k] < d.particles ? smaller(own_stretch, c.laws[d.soil[j[k]]].breaking_stretch) : own_stretch;
    };
    const Pack breaking{bears(0), bears(1), bears(2), bears(3)};
    joined = select(stretch_springs(d.traction + 8l * p, r, breaking), joined, Pack{});
  }
  const Pack wx = joined * x, wy = joined * y;
  store(pair, wx), store(pair + 4, wy), store(pair + 8, joined);
  if constexpr (PairLaw::kBonds || PairLaw::kArtificialStress) store(pair + 12, 1.0 / r);
  s.add(joined, wx, wy, x, y, vx, vy);
  return near;
}

/// Four mirror images.
template <class PairLaw>
VBGPD_INLINE void add_ghost_strain(const FlowData& d, const FlowControls& c, int i, std::int32_t p, FlowStrainSums& s) {
  const std::int32_t* const j = d.neighbours + 4l * p;
  const Quads own = broadcast_quad(d.motion + 4l * i), other = load_quads(d.motion, j);
  const Pack x = other.a - own.a, y = other.b - own.b, r2 = x * x + y * y, r = root(r2);
  Pack weight = pair_weight(c, r) * load_each(d.volume, j);
  if constexpr (PairLaw::kSprings) weight = select(r < c.spring_reach, weight, Pack{});
  const Pack vx = other.c - own.c, vy = other.d - own.d;
  add_viscosity(c, x, y, r2, vx, vy, weight, broadcast(d.constants[4l * i + 1]), s.approach);
  s.add(weight, weight * x, weight * y, x, y, vx, vy);
}

/// Sums of up to four particles in a row.
struct FlowStrains {
  Quads moment, soil_moment, velocity;  ///< M and sum V omega, of soil and images and of soil alone; sum for L
  Pack near{};                          ///< packs of soil up to the last one within the support
  bool near_wall = false;
};

template <class PairLaw>
VBGPD_INLINE FlowStrains strains_of(const FlowData& d, const FlowControls& c, int first, int count, FlowSums& sums) {
  const Pack one{1, 0, 1, 1};
  Pack moment[4] = {one, one, one, one}, soil[4] = {one, one, one, one}, velocity[4] = {};
  FlowStrains out;
  for (int k = 0; k < count; ++k) {
    const int i = first + k;
    const FlowRow row = d.rows[i];
    FlowStrainSums s;
    std::int32_t near = 0;
    for (std::int32_t p = row.begin; p < row.ghosts; ++p)
      if (add_soil_strain<PairLaw>(d, c, i, p, s)) near = p + 1 - row.begin;
    out.near[k] = near;
    moment[k] = soil[k] = sums_of(s.mxx, s.mxy, s.myy, s.total);
    if (row.ghosts < row.end) {
      for (std::int32_t p = row.ghosts; p < row.end; ++p) add_ghost_strain<PairLaw>(d, c, i, p, s);
      moment[k] = sums_of(s.mxx, s.mxy, s.myy, s.total);
      out.near_wall = true;
    }
    velocity[k] = sums_of(s.axx, s.axy, s.ayx, s.ayy);
    const FlowApproach& a = s.approach;
    store(d.next_motion + 4l * i, sums_of(a.hx, a.hy, a.sx, a.sy));
    sums.guard += 0.25 * lane_sum(a.energy);  // half of kappa (K + 4G/3) (b s - r)^2 / 2: a pair is met from both ends
  }
  out.moment = turned(moment[0], moment[1], moment[2], moment[3]);
  out.soil_moment = turned(soil[0], soil[1], soil[2], soil[3]);
  out.velocity = turned(velocity[0], velocity[1], velocity[2], velocity[3]);
  return out;
}

/// Records of up to four particles in a row; places that there are not repeat the last one.
struct FourPlaces {
  std::int32_t at[4];
  int count;
  FourPlaces(int first, int last) : count(last - first < 4 ? last - first : 4) {
    for (int k = 0; k < 4; ++k) at[k] = first + (k < count ? k : count - 1);
  }
  VBGPD_INLINE void put(double* records, const Quads& q) const {
    const Quads r = turned(q.a, q.b, q.c, q.d);
    const Pack rows[4] = {r.a, r.b, r.c, r.d};
    for (int k = 0; k < count; ++k) store(records + 4l * at[k], rows[k]);
  }
  VBGPD_INLINE void put_each(double* values, Pack v) const {
    for (int k = 0; k < count; ++k) values[at[k]] = v[k];
  }
};

VBGPD_INLINE FlowSoils soils_at(const FlowData& d, const FlowControls& c, const FourPlaces& four) {
  FlowSoils s;
  s.same = true, s.disturbed = c.disturbed;
  for (int k = 0; k < 4; ++k) {
    s.law[k] = c.laws + d.soil[four.at[k]];
    s.shear[k] = s.law[k]->constants.shear_modulus, s.bulk[k] = s.law[k]->constants.bulk_modulus;
    s.loose[k] = s.law[k]->loose;
    s.same &= s.law[k] == s.law[0];
  }
  s.extra_cohesion = d.extra_cohesion == nullptr ? Pack{} : load_each(d.extra_cohesion, four.at) * c.cohesion_scale;
  return s;
}

/// L = [sum_j V_j omega_ij (v_j - v_i) (x) xi] M^-1; mirror images take part.
///
/// in  motion (ghosts too)
///
/// in/out  stress, gap, plastic_strain, dead, springs (traction)
///
/// out  gradient, inverse, bond; left for later passes: in next_motion the forces of viscosity and guard, (kDiffuse) in
/// slope_x the inverse moment of the soil alone
template <class PairLaw, bool kDiffuse>
inline void strain_pass(const FlowData& shared, const FlowControls& shared_controls, int first, int last,
                        FlowSums& sums) {
  const FlowData d = shared;  // copies: their members stay in registers across stores
  const FlowControls c = shared_controls;
  for (int i = first; i < last; i += 4) {
    const FourPlaces four(i, last);
    const FlowStrains strains = strains_of<PairLaw>(d, c, i, four.count, sums);
    const Quads& m = strains.moment;
    const Pack one = broadcast(1);
    Inverse inverse{one, Pack{}, one};
    if constexpr (PairLaw::kCorrected) inverse = floored_inverse(m.a, m.b, m.c, c.smallest_eigenvalue);
    four.put(d.inverse, {inverse.xx, inverse.xy, inverse.yy, strains.near});
    if constexpr (kDiffuse) {
      const Quads& s = strains.soil_moment;
      const Inverse n = strains.near_wall ? floored_inverse(s.a, s.b, s.c, c.smallest_eigenvalue) : inverse;
      four.put(d.slope_x, {n.xx, n.xy, n.yy, Pack{}});
    }
    const Quads& a = strains.velocity;
    const Quads l{a.a * inverse.xx + a.b * inverse.xy, a.a * inverse.xy + a.b * inverse.yy,
                  a.c * inverse.xx + a.d * inverse.xy, a.c * inverse.xy + a.d * inverse.yy};
    four.put(d.gradient, l);

    Quads stress = load_quads(d.stress, four.at);
    Pack gap = load_each(d.gap, four.at), plastic_strain = load_each(d.plastic_strain, four.at), dead{};
    if constexpr (PairLaw::kDies) dead = load_each(d.dead, four.at);
    const Pack gap_before = gap;
    const FlowSoils soils = soils_at(d, c, four);
    const StressUpdate update = update_stress<PairLaw>(soils, c.time_step, l, m.d, stress, gap, plastic_strain, dead);
    four.put(d.stress, stress);
    four.put_each(d.gap, gap), four.put_each(d.plastic_strain, plastic_strain);
    if constexpr (PairLaw::kDies) four.put_each(d.dead, dead);

    // stress diffuses where this is below one: in soil that yields, and in disturbed soil on its way to rest, whose
    // noise would freeze in (measured: 2 % of gamma H instead of 0.4 %); soil that never moved is left as it is
    const Pack capped = smaller(update.return_ratio, broadcast(kJustBelowOne));
    const Pack ratio = select(plastic_strain > broadcast(c.disturbed), capped, update.return_ratio);
    const Pack share = select(m.d > Pack{}, 1.0 / m.d, Pack{});
    for (int k = 0; k < four.count; ++k) {
      const double volume = d.volume[i + k];
      d.bond[4l * (i + k)] = ratio[k], d.bond[4l * (i + k) + 1] = share[k];
      sums.internal += volume * update.work[k];
      if (d.pore_pressure != nullptr) {
        const double set = d.pore_pressure[i + k], bulk = soils.bulk[k];
        const double water = water_pressure(set, bulk, gap_before[k]) + water_pressure(set, bulk, gap[k]);
        sums.external += 0.5 * volume * water * update.opening[k];
      }
      if (update.return_ratio[k] < 1) sums.yielding += volume;
    }
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
