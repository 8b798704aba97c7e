// What a wall shows to the soil: particles of the same material whose motion is zero, along the wall, or prescribed.
#pragma once

#include <cmath>

namespace vbgpd {

/// How a wall particle may move.
struct WallMotion {
  double free_x = 1, free_y = 1;  ///< 1: moves by itself in that direction
  bool guided = false;            ///< true: its velocity is corrected after each step
};

inline WallMotion fixed_wall() { return {0, 0, false}; }
inline WallMotion moved_wall() { return {0, 0, true}; }
/// A roller slides along its wall. Walls along an axis cost nothing; inclined ones are corrected after each step.
inline WallMotion roller_wall(double normal_x, double normal_y) {
  constexpr double kAligned = 1e-9;
  if (std::fabs(normal_y) < kAligned) return {0, 1, false};
  if (std::fabs(normal_x) < kAligned) return {1, 0, false};
  return {1, 1, true};
}

}  // namespace vbgpd
