// What a factor of safety is going to cost on a simulation, before it is asked for.
#pragma once

#include "simulation/simulation.h"

namespace vbgpd {

struct Forecast {
  double step_seconds = 0;  ///< wall seconds of one relaxation step, measured here and now
  double steps = 0;         ///< an estimate: steps of a strength reduction on this grid alone
  double seconds = 0;       ///< steps x step_seconds
  double bytes = 0;  ///< memory while it runs: the simulation, four saved states, the grid twice as coarse, and a twin
                     ///< where stiffnesses are evened
};

/// Runs a few relaxation steps to measure (a few hundredths of a second) and puts the state back, to the last bit,
/// also when memory runs out. Throws Error(kUnsupported) for a run-out.
Forecast forecast_strength_reduction(Simulation& simulation);

}  // namespace vbgpd
