// Particles off the lattice: how much an answer owes to the particles standing in rows.
#pragma once

#include "geometry/section.h"

namespace vbgpd {

/// Fills section.shifts: each coordinate uniform within +-amplitude spacings, 0 <= amplitude < 1/2, the same for a cell
/// whatever else the section holds. Walls stay where they are, and so do cells that the outline cuts, whose particle
/// might leave the soil. Amplitude 0 leaves it empty.
void jitter(Real amplitude, Section& section);

}  // namespace vbgpd
