// What the flatbuffers JSON parser lets pass or words poorly, found beforehand: misspelt fields, missing ones, a text
// or a NaN where a number belongs, and where the text stops being JSON.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace flatbuffers {
struct StructDef;
}

namespace vbgpd {

/// One fault of the text, where it is (byte offset) and which value it concerns ("materials[1].cohesion").
struct TextProblem {
  std::size_t offset = 0;
  std::string path;
  std::string text;
  bool harmless = false;  ///< no value is lost by it
};

struct TextCheck {
  std::vector<TextProblem> problems;  ///< in the order of the text
  bool is_json = true;                ///< false: the last problem is where the text stops being JSON
  std::string mended;  ///< without the values at fault, misspelt fields as meant, so that the rest can be read
};

/// Holds JSON text against a table of a schema: every name known, every value of the right kind and of those listed
/// (one_of), nothing (needed) left out.
TextCheck check_json(std::string_view json, const flatbuffers::StructDef& table);

/// Byte offsets of the values of a table, by path; "" is the table itself.
std::map<std::string, std::size_t> places_in(std::string_view json, const flatbuffers::StructDef& table);

}  // namespace vbgpd
