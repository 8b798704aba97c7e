// Walls of a run-out step. Soil sees its mirror image behind a wall; a contact guard keeps the nearest row in front.
#pragma once

#include "step/flow_water.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// v -> v - 2 (v . n) n.
VBGPD_INLINE void reflect(const FlowWall& w, double& x, double& y) {
  const double twice = 2 * (x * w.nx + y * w.ny);
  x -= twice * w.nx, y -= twice * w.ny;
}
VBGPD_INLINE double distance_to(const FlowWall& w, double x, double y) { return (x - w.x) * w.nx + (y - w.y) * w.ny; }

/// Position S x and velocity Q v of a mirror image: Q = S where the wall is smooth, Q = -1 where it is rough.
VBGPD_INLINE void mirror_motion(const FlowWall& w, double* motion) {
  const double twice = 2 * distance_to(w, motion[0], motion[1]);
  motion[0] -= twice * w.nx, motion[1] -= twice * w.ny;
  if (w.rough != 0) motion[2] = -motion[2], motion[3] = -motion[3];
  else reflect(w, motion[2], motion[3]);
}

/// Q^T P S, the conjugate of that choice.
VBGPD_INLINE void mirror_flux(const FlowWall& w, double* flux) {
  reflect(w, flux[0], flux[1]);
  reflect(w, flux[2], flux[3]);
  if (w.rough != 0) {
    for (int k = 0; k < 4; ++k) flux[k] = -flux[k];
  } else {
    reflect(w, flux[0], flux[2]);
    reflect(w, flux[1], flux[3]);
  }
}

inline void place_ghosts(const FlowData& d) {
  for (int g = 0; g < d.ghost_count; ++g) {
    const FlowGhost& ghost = d.ghosts[g];
    const double* const parent = d.motion + 4l * ghost.parent;
    double* const image = d.motion + 4l * (d.particles + 1 + g);
    for (int k = 0; k < 4; ++k) image[k] = parent[k];
    mirror_motion(d.walls[ghost.wall], image);
    if (ghost.second >= 0) mirror_motion(d.walls[ghost.second], image);
  }
}

/// The mirrored stress is what the wall would see; over the distance 2d between particle and image it grows by the
/// weight: P_g -= 2 d rho b (x) n (only across where the wall is smooth), at most doubling the pressure there: soil
/// that carries no stress is not held up.
VBGPD_INLINE void add_weight(const FlowData& d, const FlowControls& c, const FlowWall& w, int parent,
                             const double* image, double* weight) {
  const double depth = -distance_to(w, image[0], image[1]);
  const double* const s = d.stress + 4l * parent;
  double pressure = -(s[3] + s[0] * w.nx * w.nx + s[1] * w.ny * w.ny + 2 * s[2] * w.nx * w.ny);
  pressure += water_pressure(d, c, parent);
  double share = 2 * depth / d.volume[parent];
  const double across = -share * (d.force[2l * parent] * w.nx + d.force[2l * parent + 1] * w.ny);
  if (across > 0 && across > pressure) share *= larger(pressure, 0) / across;
  double bx = share * d.force[2l * parent], by = share * d.force[2l * parent + 1];
  if (w.rough == 0) {
    const double n = bx * w.nx + by * w.ny;
    bx = n * w.nx, by = n * w.ny;
  }
  // outward normal is -n
  weight[0] += bx * w.nx, weight[1] += bx * w.ny, weight[2] += by * w.nx, weight[3] += by * w.ny;
}

inline void press_ghosts(const FlowData& d, const FlowControls& c) {
  for (int g = 0; g < d.ghost_count; ++g) {
    const FlowGhost& ghost = d.ghosts[g];
    double* const flux = d.flux + 4l * (d.particles + 1 + g);
    const double* const image = d.motion + 4l * (d.particles + 1 + g);
    for (int k = 0; k < 4; ++k) flux[k] = d.flux[4l * ghost.parent + k];
    mirror_flux(d.walls[ghost.wall], flux);
    if (ghost.second >= 0) mirror_flux(d.walls[ghost.second], flux);
    double* const weight = d.weight + 4l * (1 + g);
    for (int k = 0; k < 4; ++k) weight[k] = 0;
    add_weight(d, c, d.walls[ghost.wall], ghost.parent, image, weight);
    if (ghost.second >= 0) add_weight(d, c, d.walls[ghost.second], ghost.parent, image, weight);
  }
}

struct ContactForce {
  double x = 0, y = 0;
};

/// Force of one mirror image on particle i: what motion_pass adds up in packs.
inline ContactForce image_force(const FlowData& d, const FlowControls& c, int i, std::int32_t j) {
  const double *const own = d.motion + 4l * i, *const other = d.motion + 4l * j;
  const double x = other[0] - own[0], y = other[1] - own[1], r = root(x * x + y * y);
  if (!(r < c.image_reach)) return {};
  const double s = larger(1 - r * c.inverse_support, 0);
  const double weight = c.weight_scale * s * s * s * d.volume[j], scale = d.constants[4l * i] * weight;
  const double *const p = d.flux + 4l * i, *const q = d.flux + 4l * j, *const b = d.weight + 4l * (j - d.particles);
  const double closing = smaller((other[2] - own[2]) * x + (other[3] - own[3]) * y, 0);
  const double drag = c.viscosity * weight * d.constants[4l * i + 1] * closing / (x * x + y * y + c.softening);
  return {scale * ((p[0] + q[0] + b[0]) * x + (p[1] + q[1] + b[1]) * y) + drag * x,
          scale * ((p[2] + q[2] + b[2]) * x + (p[3] + q[3] + b[3]) * y) + drag * y};
}

/// What of it the water in the pores carries: it has no friction. Of the growth by the weight it has the share that it
/// has of the pressure.
inline ContactForce image_water(const FlowData& d, const FlowControls& c, int i, std::int32_t j) {
  if (d.pore_pressure == nullptr) return {};
  const double *const own = d.motion + 4l * i, *const other = d.motion + 4l * j;
  const double x = other[0] - own[0], y = other[1] - own[1], r = root(x * x + y * y);
  if (!(r < c.image_reach)) return {};
  const double s = larger(1 - r * c.inverse_support, 0);
  const double scale = d.constants[4l * i] * c.weight_scale * s * s * s * d.volume[j];
  const FlowGhost& ghost = d.ghosts[j - d.particles - 1];
  const double p = water_pressure(d, c, ghost.parent);
  const auto flux = [&](int k, double pressure, double* f) {
    const double* const m = d.inverse + 4l * k;
    f[0] = -pressure * m[0], f[1] = f[2] = -pressure * m[1], f[3] = -pressure * m[2];
  };
  double mine[4], its[4];
  flux(i, water_pressure(d, c, i), mine), flux(ghost.parent, p, its);
  mirror_flux(d.walls[ghost.wall], its);
  if (ghost.second >= 0) mirror_flux(d.walls[ghost.second], its);
  const FlowWall& w = d.walls[ghost.wall];
  const double *const t = d.stress + 4l * ghost.parent, *const b = d.weight + 4l * (j - d.particles);
  const double total = p - (t[3] + t[0] * w.nx * w.nx + t[1] * w.ny * w.ny + 2 * t[2] * w.nx * w.ny);
  const double share = total > 0 ? smaller(larger(p / total, 0), 1) : 0;
  return {scale * ((mine[0] + its[0] + share * b[0]) * x + (mine[1] + its[1] + share * b[1]) * y),
          scale * ((mine[2] + its[2] + share * b[2]) * x + (mine[3] + its[3] + share * b[3]) * y)};
}

/// How far behind a wall it still pushes, and how far beyond its end in a hollow corner, in reaches of the guard of the
/// largest particles: one that started close to a wall has a small guard, not less depth to come back from.
inline constexpr double kDeep = 4;

/// Push of a wall on a particle nearer than half the guard distance: a spring with a dashpot, across the wall.
struct Push {
  bool near = false;
  double nx = 0, ny = 0, force = 0;
};
inline Push push_of(const FlowData& d, const FlowControls& c, int i, const FlowWall& w) {
  const double* const m = d.motion + 4l * i;
  const double modulus = d.constants[4l * i + 2], reach = 0.5 * c.guard_distance * d.constants[4l * i + 3];
  const auto along = [&](const FlowWall& wall) { return (m[0] - wall.x) * wall.ny - (m[1] - wall.y) * wall.nx; };
  const double s = along(w), foot = larger(smaller(s, w.high), w.low);
  Push push{false, w.nx, w.ny, 0};
  double distance = distance_to(w, m[0], m[1]);
  if (foot != s) {  // beyond an end
    const bool high = s > w.high;
    const std::int32_t neighbour = high ? w.next : w.previous;
    if (neighbour < 0) return push;
    const FlowWall& other = d.walls[neighbour];
    const bool in_front_of_it = high ? along(other) >= other.low : along(other) <= other.high;
    if (in_front_of_it) return push;
    if ((high ? w.hollow_high : w.hollow_low) != 0) {  // it went through where the walls meet: both push it back
      if (magnitude(s - foot) > kDeep * c.guard_reach) return push;
    } else {  // the corner repels, once
      if (!high) return push;
      const double ex = m[0] - w.x - foot * w.ny, ey = m[1] - w.y + foot * w.nx;
      distance = root(ex * ex + ey * ey);
      if (!(distance > 0)) return push;
      push.nx = ex / distance, push.ny = ey / distance;
    }
  }
  if (distance >= reach || distance < -kDeep * c.guard_reach) return push;
  const double density = d.constants[4l * i + 1] / d.constants[4l * i], speed = root(modulus / density);
  const double across = m[2] * push.nx + m[3] * push.ny;
  push.near = true;
  push.force = larger(2 * c.guard_stiffness * modulus * (reach - distance) - c.dashpot * density * speed * across, 0);
  return push;
}

/// Force of the walls on a particle beside that of its images: the push above, and a spring along a rough wall, which
/// allows no slip (soil that carries no stress does not feel the images and would slide for ever). tell(wall, x, y)
/// hears of each.
template <class Tell>
inline ContactForce wall_contact(const FlowData& d, const FlowControls& c, int i, const Tell& tell) {
  const double* const m = d.motion + 4l * i;
  const FlowLaw& law = c.laws[d.soil[i]];
  ContactForce f;
  bool held = false;
  for (int k = 0; k < d.wall_count; ++k) {
    const FlowWall& w = d.walls[k];
    const Push push = push_of(d, c, i, w);
    if (!push.near) continue;
    f.x += push.force * push.nx, f.y += push.force * push.ny;
    tell(k, push.force * push.nx, push.force * push.ny);
    if (w.rough == 0 || held || d.rows[i].near_wall == 2) continue;  // there the one spring serves the Coulomb wall
    held = true;
    const double stiffness = law.constants.shear_modulus;
    const double stretch = d.wall_shear[i] + c.time_step * (m[2] * push.ny - m[3] * push.nx);
    d.wall_shear[i] = stretch;
    f.x -= stiffness * stretch * push.ny, f.y += stiffness * stretch * push.nx;
    tell(k, -stiffness * stretch * push.ny, stiffness * stretch * push.nx);
  }
  if (!held && d.rows[i].near_wall != 2) d.wall_shear[i] = 0;
  return f;
}

/// All that comes across wall k to particle i but for the water: of the images behind it, of those behind its corners
/// what is along its normal, and of the push.
inline double normal_force(const FlowData& d, const FlowControls& c, int i, int k) {
  const FlowWall& w = d.walls[k];
  const FlowRow row = d.rows[i];
  double sum = 0;
  for (auto n = 4l * row.ghosts; n < 4l * row.end; ++n) {
    const std::int32_t j = d.neighbours[n];
    if (j == d.particles) continue;
    const FlowGhost& ghost = d.ghosts[j - d.particles - 1];
    if (ghost.wall != k && ghost.second != k) continue;
    const ContactForce f = image_force(d, c, i, j), water = image_water(d, c, i, j);
    sum += (f.x - water.x) * w.nx + (f.y - water.y) * w.ny;
  }
  const Push push = push_of(d, c, i, w);
  return push.near ? sum + push.force * (push.nx * w.nx + push.ny * w.ny) : sum;
}

/// Friction of Coulomb walls: a spring along the wall on every particle that sees its image there, at most mu N of what
/// comes across. The images themselves slide along: a stick trial by images that stand still (Q = -1) would wind up
/// stress and spin of the rows that slide. N is the mean over a short while (Simoes & Martins 1998): friction that
/// follows every vibration of it at once feeds that vibration. One spring serves all walls of a corner; they share it
/// by their limits.
template <class Tell>
inline ContactForce wall_friction(const FlowData& d, const FlowControls& c, int i, const Tell& tell) {
  const double* const m = d.motion + 4l * i;
  const auto pressed = [&](int k) { return larger(normal_force(d, c, i, k), 0); };
  const auto share_of = [&](int k, double normal) { return c.walls_hold != 0 ? normal : d.walls[k].friction * normal; };
  double total = 0, most = 0, speed = 0, tx = 0, ty = 0, limit = 0;
  for (int k = 0; k < d.wall_count; ++k) {
    const FlowWall& w = d.walls[k];
    if (w.friction < 0) continue;
    const double normal = pressed(k), share = share_of(k, normal);
    if (share > most) most = share, speed = m[2] * w.ny - m[3] * w.nx;
    total += share, tx += share * w.ny, ty -= share * w.nx;
    limit += w.friction * normal;
  }
  double& mean = d.wall_limit[i];
  mean += (limit - mean) * (c.walls_hold != 0 ? 1 : smaller(c.friction_rate, 1));
  if (!(total > 0)) {
    d.wall_shear[i] = 0;
    return {};
  }
  const double stiffness = c.laws[d.soil[i]].constants.shear_modulus;
  double stretch = d.wall_shear[i] + c.time_step * speed;
  if (c.walls_hold == 0) stretch = larger(smaller(stretch, mean / stiffness), -mean / stiffness);
  d.wall_shear[i] = stretch;
  const double force = -stiffness * stretch / total;
  if constexpr (Tell::kListens)
    for (int k = 0; k < d.wall_count; ++k) {
      const FlowWall& w = d.walls[k];
      if (w.friction < 0) continue;
      const double share = share_of(k, pressed(k));
      tell(k, force * share * w.ny, -force * share * w.nx);
    }
  return {force * tx, force * ty};
}

struct TellNobody {
  static constexpr bool kListens = false;
  void operator()(int, double, double) const {}
};

/// Both.
template <class Tell>
inline ContactForce wall_force(const FlowData& d, const FlowControls& c, int i, const Tell& tell) {
  ContactForce f = wall_contact(d, c, i, tell);
  if (d.rows[i].near_wall != 2) return f;
  const ContactForce friction = wall_friction(d, c, i, tell);
  return {f.x + friction.x, f.y + friction.y};
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
