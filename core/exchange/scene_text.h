// Scene files: JSON text against vbgpd.fbs by the flatbuffers JSON parser. A target of its own (vbgpd_exchange_text),
// because the parser is a library the engine itself must not need at run time; programs that read scene files link it
// statically.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vbgpd {

/// JSON text -> flatbuffer bytes for scene_from_flatbuffer / vbgpd_profile_create_from_flatbuffer.
/// Throws Error(kFormat): unknown or misspelt fields, missing required ones, wrong types, with line and column and, for
/// a misspelt name, the nearest right one. `source_name` (a file name) starts the message.
std::vector<std::uint8_t> scene_text_to_flatbuffer(std::string_view json, const std::string& source_name);

}  // namespace vbgpd
