// What the flatbuffers JSON parser lets pass or words poorly, found beforehand: misspelt fields, missing ones, a text
// or a NaN where a number belongs. Grammar is left to the parser.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flatbuffers {
struct StructDef;
}

namespace vbgpd {

/// One fault of the text and where it is (byte offset).
struct TextProblem {
  std::size_t offset = 0;
  std::string text;
};

/// Holds JSON text against a table of a schema: every name known, every value of the right kind, nothing (needed) left
/// out. Stops quietly at the first thing that is not JSON.
std::vector<TextProblem> check_json(std::string_view json, const flatbuffers::StructDef& table);

/// "3:17": line and column of a byte, both from 1, the column in characters.
std::string position_text(std::string_view text, std::size_t offset);

}  // namespace vbgpd
