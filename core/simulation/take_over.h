// What was set on one grid of a scene, set on another one.
#pragma once

#include "simulation/simulation.h"

namespace vbgpd {

/// Gives `to` the loads, seismic coefficients, pore pressures and external forces of `from`: pressures as a field
/// (linear fields stay exact), forces so that their sum stays exact. Both are of the same scene.
void take_over(const Simulation& from, Simulation& to);

}  // namespace vbgpd
