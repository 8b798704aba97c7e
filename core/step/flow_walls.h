// Walls of a run-out step. Soil sees its mirror image behind a wall; a contact guard keeps the nearest row in front.
#pragma once

#include "step/flow_data.h"

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
VBGPD_INLINE void add_weight(const FlowData& d, const FlowWall& w, int parent, const double* image, double* weight) {
  const double depth = -distance_to(w, image[0], image[1]);
  const double* const s = d.stress + 4l * parent;
  const double pressure = -(s[3] + s[0] * w.nx * w.nx + s[1] * w.ny * w.ny + 2 * s[2] * w.nx * w.ny);
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

inline void press_ghosts(const FlowData& d) {
  for (int g = 0; g < d.ghost_count; ++g) {
    const FlowGhost& ghost = d.ghosts[g];
    double* const flux = d.flux + 4l * (d.particles + 1 + g);
    const double* const image = d.motion + 4l * (d.particles + 1 + g);
    for (int k = 0; k < 4; ++k) flux[k] = d.flux[4l * ghost.parent + k];
    mirror_flux(d.walls[ghost.wall], flux);
    if (ghost.second >= 0) mirror_flux(d.walls[ghost.second], flux);
    double* const weight = d.weight + 4l * (1 + g);
    for (int k = 0; k < 4; ++k) weight[k] = 0;
    add_weight(d, d.walls[ghost.wall], ghost.parent, image, weight);
    if (ghost.second >= 0) add_weight(d, d.walls[ghost.second], ghost.parent, image, weight);
  }
}

/// Force of the walls on a particle nearer than half the guard distance: a spring with a dashpot across, and a spring
/// along a rough wall, which allows no slip (soil that carries no stress does not feel the images and would slide for
/// ever).
struct ContactForce {
  double x = 0, y = 0;
};
inline ContactForce wall_contact(const FlowData& d, const FlowControls& c, int i) {
  const double* const m = d.motion + 4l * i;
  const double modulus = d.constants[4l * i + 2], reach = 0.5 * c.guard_distance * d.constants[4l * i + 3];
  const double density = d.constants[4l * i + 1] / d.constants[4l * i], speed = root(modulus / density);
  const FlowLaw& law = c.laws[d.soil[i]];
  ContactForce f;
  bool held = false;
  for (int k = 0; k < d.wall_count; ++k) {
    const FlowWall& w = d.walls[k];
    const double along = (m[0] - w.x) * w.ny - (m[1] - w.y) * w.nx;
    const double foot = larger(smaller(along, w.high), w.low);
    double nx = w.nx, ny = w.ny, distance = distance_to(w, m[0], m[1]);
    if (foot != along) {  // beyond the end of the wall: its corner repels
      const double ex = m[0] - w.x - foot * w.ny, ey = m[1] - w.y + foot * w.nx;
      distance = root(ex * ex + ey * ey);
      if (!(distance > 0)) continue;
      nx = ex / distance, ny = ey / distance;
    }
    if (distance >= reach || distance < -8 * reach) continue;
    const double across = m[2] * nx + m[3] * ny;
    const double normal =
        larger(2 * c.guard_stiffness * modulus * (reach - distance) - c.dashpot * density * speed * across, 0);
    f.x += normal * nx, f.y += normal * ny;
    if (w.rough == 0 || held) continue;
    held = true;
    const double stiffness = law.constants.shear_modulus;
    const double stretch = d.wall_shear[i] + c.time_step * (m[2] * ny - m[3] * nx);
    d.wall_shear[i] = stretch;
    f.x -= stiffness * stretch * ny, f.y += stiffness * stretch * nx;
  }
  if (!held) d.wall_shear[i] = 0;
  return f;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
