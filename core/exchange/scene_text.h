// Scene files: JSON text against vbgpd.fbs by the flatbuffers JSON parser. A target of its own (vbgpd_exchange_text),
// because the parser is a library the engine itself must not need at run time; programs that read scene files link it
// statically.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/text_position.h"

namespace vbgpd {

/// JSON text -> flatbuffer bytes for scene_from_flatbuffer / vbgpd_profile_create_from_flatbuffer.
/// Throws Error(kFormat): unknown or misspelt fields, missing required ones, wrong types, with line and column and, for
/// a misspelt name, the nearest right one; a line for each of the first twenty. `source_name` (a file name) starts the
/// lines.
std::vector<std::uint8_t> scene_text_to_flatbuffer(std::string_view json, const std::string& source_name);

/// A fault of a scene text.
struct SceneFault {
  TextPosition position;
  std::string path;  ///< the value it concerns: "materials[1].cohesion"
  std::string text;
  bool harmless = false;  ///< no value is lost by it
};

/// A scene text read as far as it can be, for programs that tell all that is wrong with it at once.
struct SceneText {
  std::vector<SceneFault> faults;   ///< in the order of the text; the last may be that it is no JSON from there on
  std::vector<std::uint8_t> bytes;  ///< without what is at fault; empty where the rest would be misread
};
/// Throws Error(kFormat) where the file is no text.
SceneText read_scene_text(std::string_view json, const std::string& source_name);

/// Where in the text the values are that issues are about ("materials[1] 'sand': cohesion = -1 Pa: ..." or "scene: kh
/// ..."); the nearest thing around a value that is not written, nowhere (0:0) when that is the scene itself.
std::vector<TextPosition> issue_positions(std::span<const std::string> issues, std::string_view json);

/// Whether an issue of the scene in bytes may only be there because of a fault of the text: it is about the value at
/// fault, or needs it.
bool may_follow_from(std::string_view issue, const SceneFault& fault);

}  // namespace vbgpd
