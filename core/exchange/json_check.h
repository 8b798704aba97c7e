// What the flatbuffers JSON parser lets pass or words poorly, found beforehand: misspelt fields, missing ones, a text
// or a NaN where a number belongs. Grammar is left to the parser.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/text_position.h"

namespace flatbuffers {
struct StructDef;
}

namespace vbgpd {

/// One fault of the text, where it is (byte offset) and which value it concerns ("materials[1].cohesion").
struct TextProblem {
  std::size_t offset = 0;
  std::string path;
  std::string text;
};

struct TextCheck {
  std::vector<TextProblem> problems;  ///< the first twenty, in the order of the text
  std::string mended;                 ///< the text without the values at fault, so that the rest of it can be read
};

/// Holds JSON text against a table of a schema: every name known, every value of the right kind and of those listed
/// (one_of), nothing (needed) left out. Stops quietly at the first thing that is not JSON.
TextCheck check_json(std::string_view json, const flatbuffers::StructDef& table);

/// Byte offset of the value called `path`, or of the nearest thing around it that is there.
std::size_t place_of(std::string_view path, std::string_view json, const flatbuffers::StructDef& table);

/// Line and column of a byte.
TextPosition position(std::string_view text, std::size_t offset);

}  // namespace vbgpd
