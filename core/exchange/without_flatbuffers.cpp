// The build without flatbuffers: scenes are made by calls.
#include "base/error.h"
#include "exchange/checkpoint.h"
#include "exchange/scene_buffer.h"
#include "exchange/snapshot.h"

namespace vbgpd {

namespace {

[[noreturn]] void unsupported() {
  throw Error(
      Status::kUnsupported,
      "this build has no flatbuffers (VBGPD_WITH_FLATBUFFERS=OFF): make the scene by calls, or use a build that has");
}

}  // namespace

SceneDef scene_from_flatbuffer(std::span<const std::uint8_t>) { unsupported(); }
std::vector<std::uint8_t> scene_to_flatbuffer(const SceneDef&) { unsupported(); }
std::vector<std::uint8_t> checkpoint_to_bytes(const Checkpoint&) { unsupported(); }
Checkpoint checkpoint_from_bytes(std::span<const std::uint8_t>) { unsupported(); }
std::vector<std::uint8_t> snapshot_to_bytes(const Snapshot&) { unsupported(); }
bool reads_flatbuffers() noexcept { return false; }

}  // namespace vbgpd
