// Numbers in sentences, without locale.
#pragma once

#include <charconv>
#include <string>

namespace vbgpd {

inline std::string format(double value, int digits = 6) {
  char buffer[32];
  const auto r = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
  return std::string(buffer, r.ptr);
}

}  // namespace vbgpd
