// Neighbour search of the run-out side: particles sorted by cell, listed with a skin, their images behind the walls,
// and the tractions of the bonds that live on.
#pragma once

#include <functional>

#include "state/flow_model.h"

namespace vbgpd {

/// Sorts the state by cells of the present positions, lists neighbours and images, hands tractions over. `lists` is the
/// present one and becomes the new one. Answers whether the particles are stored in another order now. `prepare` gets
/// the new lists before they are put in place; when it or anything else throws, state and lists are as they were.
bool search_neighbours(const FlowModel& m, FlowState& s, FlowLists& lists,
                       const std::function<void(const FlowLists&)>& prepare = {});

/// Law pseudo_spring: joins every pair nearer than the reach of a spring, at rest as it is now; all others part.
void join_neighbours(const FlowModel& m, FlowState& s, const FlowLists& lists);

/// How many pairs of particles and images the next listing has to look at: a few dozen a particle, unless positions
/// that nobody moved there lie on top of each other.
std::int64_t listing_work(const FlowModel& m, const FlowState& s);

/// Writes the forces and pore pressures of the model to the present places of the particles.
void place_forces(const FlowModel& m, const FlowState& s, FlowLists& lists);

/// The same lists again from a saved state (nothing is sorted, tractions stay).
void list_neighbours(const FlowModel& m, const FlowState& s, FlowLists& lists);

}  // namespace vbgpd
