// Particles numbered along lattice lines, bonds gathered into packs, neighbour operators of VB1.
#pragma once

#include "smoothing/any_kernel.h"
#include "state/model.h"

namespace vbgpd {

/// Particles of a lattice line beyond which what the passes of a step share does not stay in cache.
inline constexpr int kLongestLine = 600;

/// Fills everything of `m` that follows from the lattice: numbering, offsets, blocks, neighbours, packs, chunks,
/// volume, share, moments, scaled_mass. `h` is the smoothing length, m, `jitter` what section.shifts were
/// made with. Needs m.width, m.features and the materials'
/// pair tables.
void build_packs(const Section& section, Real jitter, const AnyKernel& kernel, Real h, Model& m);

}  // namespace vbgpd
