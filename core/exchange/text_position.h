// A place in a text.
#pragma once

#include <compare>
#include <cstddef>
#include <string>

namespace vbgpd {

/// Line and column, both from 1, the column in characters; 0:0 is nowhere.
struct TextPosition {
  std::size_t line = 0, column = 0;
  auto operator<=>(const TextPosition&) const = default;
  std::string text() const { return std::to_string(line) + ":" + std::to_string(column); }
};

}  // namespace vbgpd
