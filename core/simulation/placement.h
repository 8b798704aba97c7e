// A state carried over to the same section with soil taken away or placed.
#pragma once

#include "geometry/section.h"
#include "state/model.h"

namespace vbgpd {

/// The state of `from` for the model `to` of the same section with other layers; both number and store particles alike.
/// Particles that are in both keep displacement, velocity and plastic strain. With `places` what is new moves along
/// with the nearest particle that was there (walls: of the same boundary), at rest, and the strain this means, its own
/// and that of the old soil beside it, is booked as the shape it was placed in: no stress changes. Then `gradients`
/// must hold the displacement gradients of `state`; those of the new state are left in `scratch`.
State carried_over(const Section& section, const Model& from, const State& state, const Scratch& gradients,
                   const Model& to, bool places, Scratch& scratch);

/// True when anything of the state is not zero: soil placed now is placed on a section that has moved.
bool has_moved(const State& state);

}  // namespace vbgpd
