// What a failing slope does between two instants: who moves, where it shears, along which line.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace vbgpd {

/// Displacement and plastic strain of every particle at one instant, by particle id.
struct Instant {
  std::vector<double> displacement;    ///< [n x 2] m
  std::vector<double> plastic_strain;  ///< [n]
};
Instant instant(const Simulation& simulation);

/// True when the particles that sheared most between two instants form a connected band that joins two places of the
/// outline (free surface or held boundary) at least a quarter of the height apart: a kinematic mechanism, not a local
/// yield zone.
bool band_connected(const Simulation& simulation, const Instant& before, const Instant& after);

struct SlipSurface {
  std::vector<Point> line;  ///< left to right, m
  double sliding_area = 0;  ///< of the moving mass, m2
  /// Where the soil slides down to both sides at once, like a dam that fails on both faces, the one of the slides that
  /// the line is of: -1 the left one, 1 the right one; 0 where there is one slide.
  int side = 0;
};
/// The slip line of the motion between two instants: the edge of the moving mass inside the soil (|du| = half the
/// motion of the mass), each point drawn to the plastic-rate weighted centre of the band along the edge's normal,
/// smoothed. Where the soil slides to both sides it is the line of the slide that moves more, of two alike the left
/// one.
SlipSurface slip_surface(const Simulation& simulation, const Instant& before, const Instant& after);

}  // namespace vbgpd
