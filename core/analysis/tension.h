// How deep soil hangs in tension below the ground, where it might crack.
#pragma once

#include "simulation/simulation.h"

namespace vbgpd {

/// Depth below the ground, m, down to which the major principal stress in the section's plane is tension from the
/// surface on; the deepest such column, elastic soils and those with a tension cut-off left out. 0 where there is none.
Real tension_depth(const Simulation& simulation);

}  // namespace vbgpd
