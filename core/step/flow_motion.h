// Third pass of a run-out step: forces from virtual power, viscosity, short-range guard, walls; kick, drift; diffusion.
#pragma once

#include "step/flow_pair_laws.h"
#include "step/flow_walls.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Sums over the neighbours of one particle.
struct FlowForceSums {
  Pack fx{}, fy{}, bx{}, by{}, hx{}, hy{};  ///< stress of soil and images; weight term of images; viscosity
  Pack sx{}, sy{}, energy{};                ///< short-range guard
  Pack xx{}, yy{}, xy{}, m{};               ///< diffused stress
  Pack ax{}, ay{};                          ///< artificial stress
};

/// Forces of four soil neighbours. Every term is equal and opposite for the other end, bit by bit.
template <class PairLaw, bool kDiffuse>
VBGPD_INLINE void add_soil(const FlowData& d, const FlowControls& c, int i, std::int32_t p, FlowForceSums& s) {
  const std::int32_t* const j = d.neighbours + 4l * p;
  const Quads own = broadcast_quad(d.motion + 4l * i), other = load_quads(d.motion, j);
  const Pack x = other.a - own.a, y = other.b - own.b, r2 = x * x + y * y, r = root(r2);
  const Pack weight = pair_weight(c, r);
  if (!any(weight > Pack{})) return;
  const Quads mine = broadcast_quad(d.flux + 4l * i), its = load_quads(d.flux, j);
  const Quads self = broadcast_quad(d.constants + 4l * i), end = load_quads(d.constants, j);
  Pack joined = weight;
  if constexpr (PairLaw::kSprings) joined = select(load(d.traction + 8l * p + 4) > Pack{}, weight, Pack{});
  const Pack wx = joined * end.a * x, wy = joined * end.a * y;
  s.fx += (mine.a + its.a) * wx + (mine.b + its.b) * wy;
  s.fy += (mine.c + its.c) * wx + (mine.d + its.d) * wy;
  if constexpr (PairLaw::kArtificialStress) {
    const Pack close = closeness(c, r);
    const Quads a = broadcast_quad(d.artificial + 4l * i), b = load_quads(d.artificial, j);
    s.ax += close * ((a.a + b.a) * wx + (a.c + b.c) * wy);
    s.ay += close * ((a.c + b.c) * wx + (a.b + b.b) * wy);
  }
  // Monaghan's viscosity on approach: V_i V_j rho omega (alpha c h) (v . xi)/(r2 + 0.01 h2) xi, v . xi < 0
  const Pack closing = smaller((other.c - own.c) * x + (other.d - own.d) * y, Pack{});
  const Pack mass = self.b * end.a + self.a * end.b;
  const Pack drag = 0.5 * c.viscosity * weight * mass * closing / (r2 + c.softening);
  s.hx += drag * x, s.hy += drag * y;
  // guard: kappa (K + 4G/3) (b s - r), s the mean side of the two particles
  if constexpr (PairLaw::kGuard) {
    const Pack overlap = larger(0.5 * c.guard_distance * (self.d + end.d) - r, Pack{});
    if (any(overlap > Pack{})) {
      const Pack push = 0.5 * c.guard_stiffness * (self.c + end.c) * overlap, over_r = push / r;
      s.sx -= over_r * x, s.sy -= over_r * y;
      s.energy += push * overlap;
    }
  }
  if constexpr (kDiffuse) {
    const Quads bond = broadcast_quad(d.bond + 4l * i), far = load_quads(d.bond, j);
    const auto yields = smaller(bond.a, far.a) < 1.0;
    if (!any(yields)) return;
    const Pack share = select(yields, weight * end.a, Pack{});
    const Quads a = broadcast_quad(d.stress + 4l * i), b = load_quads(d.stress, j);
    const Quads ax = broadcast_quad(d.slope_x + 4l * i), bx = load_quads(d.slope_x, j);
    const Quads ay = broadcast_quad(d.slope_y + 4l * i), by = load_quads(d.slope_y, j);
    const Pack hx = 0.5 * x, hy = 0.5 * y;
    s.xx += share * (b.a - a.a - (ax.a + bx.a) * hx - (ay.a + by.a) * hy);
    s.yy += share * (b.b - a.b - (ax.b + bx.b) * hx - (ay.b + by.b) * hy);
    s.xy += share * (b.c - a.c - (ax.c + bx.c) * hx - (ay.c + by.c) * hy);
    s.m += share * (b.d - a.d - (ax.d + bx.d) * hx - (ay.d + by.d) * hy);
  }
}

template <class PairLaw>
VBGPD_INLINE void add_ghosts(const FlowData& d, const FlowControls& c, int i, std::int32_t p, FlowForceSums& s) {
  const std::int32_t* const j = d.neighbours + 4l * p;
  const Quads own = broadcast_quad(d.motion + 4l * i), other = load_quads(d.motion, j);
  const Quads mine = broadcast_quad(d.flux + 4l * i), its = load_quads(d.flux, j);
  const Pack x = other.a - own.a, y = other.b - own.b, r = root(x * x + y * y);
  Pack weight = pair_weight(c, r) * load_each(d.volume, j);
  if constexpr (PairLaw::kSprings) weight = select(r < c.spring_reach, weight, Pack{});
  const Pack wx = weight * x, wy = weight * y;
  s.fx += (mine.a + its.a) * wx + (mine.b + its.b) * wy;
  s.fy += (mine.c + its.c) * wx + (mine.d + its.d) * wy;
  const int n = d.particles;
  const std::int32_t image[4] = {j[0] - n, j[1] - n, j[2] - n, j[3] - n};
  const Quads b = load_quads(d.weight, image);
  s.bx += b.a * wx + b.b * wy;
  s.by += b.c * wx + b.d * wy;
  const Pack closing = smaller((other.c - own.c) * x + (other.d - own.d) * y, Pack{});
  const Pack drag = c.viscosity * weight * d.constants[4l * i + 1] * closing / (x * x + y * y + c.softening);
  s.hx += drag * x, s.hy += drag * y;
}

/// -alpha |f| sgn v
VBGPD_INLINE double local_damping(double alpha, double force, double velocity) {
  if (velocity == 0) return 0;
  return velocity > 0 ? -alpha * magnitude(force) : alpha * magnitude(force);
}

/// in  motion, flux (ghosts too), pair_force, stress, slopes   out  next_motion, next_stress (kDiffuse)
template <class PairLaw, bool kDiffuse>
inline void motion_pass(const FlowData& shared, const FlowControls& shared_controls, int first, int last,
                        FlowSums& sums) {
  const FlowData d = shared;
  const FlowControls c = shared_controls;
  const double dt = c.time_step;
  for (int i = first; i < last; ++i) {
    const FlowRow row = d.rows[i];
    FlowForceSums s;
    for (std::int32_t p = row.begin; p < row.ghosts; ++p) add_soil<PairLaw, kDiffuse>(d, c, i, p, s);
    for (std::int32_t p = row.ghosts; p < row.end; ++p) add_ghosts<PairLaw>(d, c, i, p, s);
    const Pack f = sums_of(s.fx, s.fy, s.hx, s.hy), g = sums_of(s.sx, s.sy, s.energy, Pack{});
    const Pack w = row.near_wall != 0 ? sums_of(s.bx, s.by, Pack{}, Pack{}) : Pack{};
    const ContactForce wall = row.near_wall != 0 ? wall_force(d, c, i, TellNobody{}) : ContactForce{};
    const double volume = d.constants[4l * i], mass = d.constants[4l * i + 1];
    const double ex = d.force[2l * i], ey = d.force[2l * i + 1];
    double pair_x = 0, pair_y = 0;
    if constexpr (PairLaw::kBonds) pair_x = d.pair_force[2l * i], pair_y = d.pair_force[2l * i + 1];
    if constexpr (PairLaw::kArtificialStress) {
      const Pack a = sums_of(s.ax, s.ay, Pack{}, Pack{});
      pair_x = volume * a[0], pair_y = volume * a[1];
    }
    const double fx = volume * (f[0] + w[0]) + pair_x + f[2] + g[0] + wall.x + ex;
    const double fy = volume * (f[1] + w[1]) + pair_y + f[3] + g[1] + wall.y + ey;
    const double* const m = d.motion + 4l * i;
    double* const next = d.next_motion + 4l * i;
    const double dx = local_damping(c.local_damping, fx, m[2]), dy = local_damping(c.local_damping, fy, m[3]);
    next[2] = m[2] + dt / mass * (fx + dx), next[3] = m[3] + dt / mass * (fy + dy);
    next[0] = m[0] + dt * next[2], next[1] = m[1] + dt * next[3];
    if constexpr (kDiffuse) {
      const double wave_speed = root(d.constants[4l * i + 2] * volume / mass);
      const Pack change = sums_of(s.xx, s.yy, s.xy, s.m) * (c.diffusion * wave_speed * dt);
      store(d.next_stress + 4l * i, load(d.stress + 4l * i) + change);
    }
    const double mx = 0.5 * dt * (m[2] + next[2]), my = 0.5 * dt * (m[3] + next[3]);
    const double ux = next[0] - d.listed[2l * i], uy = next[1] - d.listed[2l * i + 1];
    sums.unbalanced += magnitude(fx) + magnitude(fy);
    sums.kinetic += 0.5 * mass * (next[2] * next[2] + next[3] * next[3]);
    sums.velocity2 = larger(sums.velocity2, next[2] * next[2] + next[3] * next[3]);
    sums.displacement2 = larger(sums.displacement2, ux * ux + uy * uy);
    sums.external += ex * mx + ey * my;
    if constexpr (PairLaw::kArtificialStress) sums.bond -= pair_x * mx + pair_y * my;
    sums.viscous -= f[2] * mx + f[3] * my;
    sums.damping -= dx * mx + dy * my;
    sums.contact -= wall.x * mx + wall.y * my;
    sums.wall += volume * (w[0] * mx + w[1] * my);
    sums.guard += 0.25 * g[2];  // half of kappa (K + 4G/3) (b dx - r)^2 / 2: a pair is met from both ends
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
