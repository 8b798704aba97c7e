// Snapshots as bytes: what can be seen of a model, for other programs. Written, never read by the engine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vbgpd {

/// The fields of snapshot.fbs; arrays by particle id.
struct Snapshot {
  std::string version, name;
  double time = 0;
  std::int64_t steps = 0;
  double strength_reduction_factor = 1, spacing_x = 0, spacing_y = 0;
  std::uint64_t state_hash = 0;
  std::vector<std::string> materials;
  std::vector<std::int64_t> particle_id, material, boundary;
  std::vector<double> position, displacement, velocity, stress, plastic_strain, volume;
  std::vector<double> pore_pressure;  ///< empty = 0 everywhere
};

inline constexpr std::uint32_t kSnapshotFormat = 1;

/// Throws Error(kLimit) beyond the two gigabytes a flatbuffer can hold, Error(kUnsupported) without flatbuffers.
std::vector<std::uint8_t> snapshot_to_bytes(const Snapshot& snapshot);

}  // namespace vbgpd
