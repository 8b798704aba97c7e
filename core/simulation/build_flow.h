// Hand-over: the soil of a lattice model becomes a flow model.
#pragma once

#include "simulation/lattice_simulation.h"
#include "state/flow_model.h"

namespace vbgpd {

/// Particles at the centroids of the cells whose soil is there, displaced as they are now, numbered one after the other
/// (without layers switched off by the same ids); the walls of the whole profile; strengths, weights and loads as they
/// were. Dilatancy is left out: constant dilatancy would swell a flowing soil without end. A soil whose tension cut-off
/// is not given carries no tension (pseudo-springs: that of c and phi). Throws Error(kUnsupported) for moving walls and
/// for kernels other than Wendland C2.
FlowModel build_flow_model(const LatticeSimulation& from, const FlowOptions& options);

/// Positions, stresses and plastic strain at the hand-over; velocities are zero.
FlowState handed_over(const LatticeSimulation& from, const FlowModel& model);

/// Forces and pore pressures that were set from outside, by particle id.
Outside handed_over_forces(const LatticeSimulation& from, const FlowModel& model);

/// The external force of rows x, y by particle id; absent when all are zero.
void push_by(const std::vector<double>& forces, const Heap& heap, Outside& outside);
/// A pore pressure by particle id; absent when all are zero.
Array pressure_of(const std::vector<double>& rows, const Heap& heap);

}  // namespace vbgpd
