// What a run-out has done so far, read off the fields: how far the front came, how much moved, where the ground is now.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace vbgpd {

struct RunoutShape {
  Real crest_settlement =
      0;  ///< largest sinking of the soil that lay within a spacing and a half of the highest ground, m
  /// The toe is the foot of the slope on the side where the front went farther (the lower one as long as none did): of
  /// the free outline from the highest ground to that side, the point farthest below the straight line from end to end.
  Real toe_displacement = 0;  ///< largest way of the soil within one and a half spacings of the toe, m
  /// Front of what came from behind the toe, in the connected mass, and moved by more than a spacing to that side: how
  /// far it is beyond the toe, m. Ground before the toe that is pushed up or along does not count.
  Real runout_distance = 0;
  Real stopped_at = kNone;    ///< x of the wall that ends the section, where the front has come up to it, m
  Real moved_area = 0;        ///< soil that moved by more than a spacing, m2
  Real plastic_fraction = 0;  ///< share of the soil that has yielded
};
RunoutShape runout_shape(const Simulation& simulation);

/// The present ground surface from left to right, m: upper edge of the largest connected mass in columns of a spacing.
std::vector<Point> ground_surface(const Simulation& simulation);

}  // namespace vbgpd
