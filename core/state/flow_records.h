// The lists of a flow model as plain data: what the instruction-set specific files see.
#pragma once

#include <cstdint>

namespace vbgpd {

/// Neighbours of one particle, four to a pack: soil in [begin, ghosts), mirror images in [ghosts, end).
struct FlowRow {
  std::int32_t begin = 0, ghosts = 0, end = 0;
  std::int32_t near_wall = 0;  ///< 1: sees images; 2: some of them in a Coulomb wall
};

/// A mirror image of a particle behind one wall, or behind the corner of two.
struct FlowGhost {
  std::int32_t parent = 0, wall = 0, second = -1;
};

/// Two groups of particles whose cells touch, or one with itself.
struct FlowTouch {
  std::int32_t a = 0, b = 0;
};

/// A straight wall. It mirrors the soil in front of it; low and high may be infinite.
struct FlowWall {
  double x = 0, y = 0;        ///< a point of it, m
  double nx = 0, ny = 1;      ///< unit normal into the soil
  double low = 0, high = 0;   ///< extent along (ny, -nx) from that point, m
  std::int32_t rough = 1;     ///< 1: holds the soil on it; 0: only what comes across
  double friction = -1;       ///< >= 0: tan of the friction angle of a Coulomb wall, which mirrors like a smooth one
  std::int32_t boundary = 0;  ///< of the section
  std::int32_t previous = -1, next = -1;  ///< the walls that end where this one begins, begin where it ends; -1 = none
  std::int32_t hollow_low = 0, hollow_high = 0;  ///< 1: the soil lies in the corner with them, not around it
};

}  // namespace vbgpd
