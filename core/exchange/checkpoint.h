// Checkpoints as bytes. Incoming ones are verified, copied and checked; what depends on the section is checked by the
// simulation that takes them (Simulation::restore_image).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/state_image.h"
#include "scene/scene_def.h"

namespace vbgpd {

/// The newest that is read, and that of run-outs and of models at rest with soil that can come apart (4: its gaps);
/// other models at rest are written as 1.
inline constexpr std::uint32_t kCheckpointFormat = 4;

struct Checkpoint {
  SceneDef scene;
  double spacing_factor = 1;
  int lattice_multiple = 2, coarsening = 1;
  StateImage state;
};

/// Throws Error(kLimit) beyond the two gigabytes a flatbuffer can hold.
std::vector<std::uint8_t> checkpoint_to_bytes(const Checkpoint& checkpoint);
/// Throws Error(kFormat) for anything but a whole checkpoint, Error(kVersion) for a newer format or a run-out in an
/// older one.
Checkpoint checkpoint_from_bytes(std::span<const std::uint8_t> bytes);

}  // namespace vbgpd
