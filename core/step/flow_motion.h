// Third pass of a run-out step: forces from virtual power, viscosity, short-range guard, walls; kick, drift; diffusion.
#pragma once

#include "step/flow_pair_laws.h"
#include "step/flow_walls.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Sums over the neighbours of one particle.
struct FlowForceSums {
  Pack along{}, up{};               ///< sum V_j omega P_j xi, by component of P, soil
  Pack wx{}, wy{};                  ///< sum V_j omega xi
  Pack fx{}, fy{}, bx{}, by{};      ///< stress of images, their weight term
  Pack flow{}, flow_x{}, flow_y{};  ///< diffused stress by component: of the stress, of the slopes
  Pack dw{}, dx{}, dy{};            ///< of the pairs that diffuse: sum V_j omega, sum V_j omega xi
  Pack ax{}, ay{};                  ///< artificial stress
};

/// What four neighbours give particle i by diffusion. weights: V_j omega xi_x, V_j omega xi_y, V_j omega, four each.
VBGPD_INLINE void add_diffusion(const FlowData& d, const std::int32_t* j, const double* weights, FlowForceSums& s) {
  s.dx += load(weights), s.dy += load(weights + 4), s.dw += load(weights + 8);
  for (int k = 0; k < 4; ++k) {
    s.flow += load(d.stress + 4l * j[k]) * broadcast(weights[8 + k]);
    s.flow_x += load(d.slope_x + 4l * j[k]) * broadcast(weights[k]);
    s.flow_y += load(d.slope_y + 4l * j[k]) * broadcast(weights[4 + k]);
  }
}

/// Forces of four soil neighbours. Every term is equal and opposite for the other end, to round-off. diffuse_all: with
/// particle i diffuses every pair of it.
template <class PairLaw, bool kDiffuse>
VBGPD_INLINE void add_soil(const FlowData& d, const FlowControls& c, int i, std::int32_t p, bool diffuse_all,
                           FlowForceSums& s) {
  const std::int32_t* const j = d.neighbours + 4l * p;
  const double* const pair = d.pairs + 16l * p;
  const Pack wx = load(pair), wy = load(pair + 4);
  s.wx += wx, s.wy += wy;
  for (int k = 0; k < 4; ++k) {
    const Pack flux = load(d.flux + 4l * j[k]);
    s.along += flux * broadcast(pair[k]), s.up += flux * broadcast(pair[4 + k]);
  }
  if constexpr (PairLaw::kArtificialStress) {
    const Pack close = closeness(c, 1.0 / load(pair + 12));
    const Quads a = broadcast_quad(d.artificial + 4l * i), b = load_quads(d.artificial, j);
    s.ax += close * ((a.a + b.a) * wx + (a.c + b.c) * wy);
    s.ay += close * ((a.c + b.c) * wx + (a.b + b.b) * wy);
  }
  if constexpr (kDiffuse) {
    if (diffuse_all) return add_diffusion(d, j, pair, s);
    const Pack ratio{d.bond[4l * j[0]], d.bond[4l * j[1]], d.bond[4l * j[2]], d.bond[4l * j[3]]};
    const auto diffuses = ratio < 1.0;
    if (!any(diffuses)) return;
    alignas(32) double chosen[12];
    store(chosen, select(diffuses, wx, Pack{})), store(chosen + 4, select(diffuses, wy, Pack{}));
    store(chosen + 8, select(diffuses, load(pair + 8), Pack{}));
    add_diffusion(d, j, chosen, s);
  }
}

template <class PairLaw>
VBGPD_INLINE void add_ghosts(const FlowData& d, const FlowControls& c, int i, std::int32_t p, FlowForceSums& s) {
  const std::int32_t* const j = d.neighbours + 4l * p;
  const FirstTwo other = load_first_two(d.motion, j);
  const Quads mine = broadcast_quad(d.flux + 4l * i), its = load_quads(d.flux, j);
  const Pack x = other.a - d.motion[4l * i], y = other.b - d.motion[4l * i + 1], r = root(x * x + y * y);
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
}

/// -alpha |f| sgn v
VBGPD_INLINE double local_damping(double alpha, double force, double velocity) {
  if (velocity == 0) return 0;
  return velocity > 0 ? -alpha * magnitude(force) : alpha * magnitude(force);
}

/// in  motion, flux (ghosts too), pair_force, next_motion (forces on approach), stress, slopes
/// out  next_motion, next_stress (kDiffuse)
template <class PairLaw, bool kDiffuse>
inline void motion_pass(const FlowData& shared, const FlowControls& shared_controls, int first, int last,
                        FlowSums& sums) {
  const FlowData d = shared;
  const FlowControls c = shared_controls;
  const double dt = c.time_step;
  for (int i = first; i < last; ++i) {
    const FlowRow row = d.rows[i];
    FlowForceSums s;
    const bool disturbed = d.bond[4l * i] < 1;
    const std::int32_t near = row.begin + static_cast<std::int32_t>(d.inverse[4l * i + 3]);
    for (std::int32_t p = row.begin; p < near; ++p) add_soil<PairLaw, kDiffuse>(d, c, i, p, disturbed, s);
    for (std::int32_t p = row.ghosts; p < row.end; ++p) add_ghosts<PairLaw>(d, c, i, p, s);
    double* const next = d.next_motion + 4l * i;
    const double hx = next[0], hy = next[1], gx = next[2], gy = next[3];  // viscosity, guard
    const bool near_wall = row.near_wall != 0;
    const Pack w = near_wall ? sums_of(s.fx, s.fy, s.bx, s.by) : Pack{};
    const double* const flux = d.flux + 4l * i;
    const Pack own = sums_of(s.wx, s.wy, Pack{}, Pack{});
    const double sx = s.along[0] + s.up[1] + flux[0] * own[0] + flux[1] * own[1] + w[0];
    const double sy = s.along[2] + s.up[3] + flux[2] * own[0] + flux[3] * own[1] + w[1];
    const ContactForce wall = near_wall ? wall_force(d, c, i, TellNobody{}) : ContactForce{};
    const double volume = d.constants[4l * i], mass = d.constants[4l * i + 1];
    const double ex = d.force[2l * i], ey = d.force[2l * i + 1];
    double pair_x = 0, pair_y = 0;
    if constexpr (PairLaw::kBonds) pair_x = d.pair_force[2l * i], pair_y = d.pair_force[2l * i + 1];
    if constexpr (PairLaw::kArtificialStress) {
      const Pack a = sums_of(s.ax, s.ay, Pack{}, Pack{});
      pair_x = volume * a[0], pair_y = volume * a[1];
    }
    const double fx = volume * (sx + w[2]) + pair_x + hx + gx + wall.x + ex;
    const double fy = volume * (sy + w[3]) + pair_y + hy + gy + wall.y + ey;
    const double* const m = d.motion + 4l * i;
    const double dx = local_damping(c.local_damping, fx, m[2]), dy = local_damping(c.local_damping, fy, m[3]);
    next[2] = m[2] + dt / mass * (fx + dx), next[3] = m[3] + dt / mass * (fy + dy);
    next[0] = m[0] + dt * next[2], next[1] = m[1] + dt * next[3];
    if constexpr (kDiffuse) {
      const double wave_speed = root(d.constants[4l * i + 2] * volume / mass);
      const Pack stress = load(d.stress + 4l * i), own_share = sums_of(s.dw, s.dx, s.dy, Pack{});
      const Pack slopes = load(d.slope_x + 4l * i) * own_share[1] + load(d.slope_y + 4l * i) * own_share[2];
      const Pack flow = s.flow - stress * own_share[0] - slopes - s.flow_x - s.flow_y;
      store(d.next_stress + 4l * i, stress + flow * (c.diffusion * wave_speed * dt));
    }
    const double mx = 0.5 * dt * (m[2] + next[2]), my = 0.5 * dt * (m[3] + next[3]);
    sums.unbalanced += magnitude(fx) + magnitude(fy);
    sums.kinetic += 0.5 * mass * (next[2] * next[2] + next[3] * next[3]);
    sums.velocity2 = larger(sums.velocity2, next[2] * next[2] + next[3] * next[3]);
    sums.external += ex * mx + ey * my;
    if constexpr (PairLaw::kArtificialStress) sums.bond -= pair_x * mx + pair_y * my;
    sums.viscous -= hx * mx + hy * my;
    sums.damping -= dx * mx + dy * my;
    sums.contact -= wall.x * mx + wall.y * my;
    sums.wall += volume * (w[2] * mx + w[3] * my);
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
