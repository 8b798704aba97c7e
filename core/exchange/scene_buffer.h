// Scenes as flatbuffers (file identifier "VBGP"). flatbuffers lives in this folder and nowhere else.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene_def.h"

namespace vbgpd {

/// A scene from bytes of a flatbuffer. The bytes are size-limited, verified and copied, never trusted, never aliased.
/// Converts the units written in the buffer ("SI" or "kPa") to SI. Throws Error(kFormat) with a sentence that says what
/// is wrong.
SceneDef scene_from_flatbuffer(std::span<const std::uint8_t> bytes);

/// The same scene as bytes, always in SI.
std::vector<std::uint8_t> scene_to_flatbuffer(const SceneDef& scene);

/// Whether this build can; without flatbuffers the two above throw Error(kUnsupported).
bool reads_flatbuffers() noexcept;

}  // namespace vbgpd
