// Numbers in messages: locale-free, with as many digits as the size of the section needs.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "base/types.h"
#include "scene/wording.h"

namespace vbgpd {

/// Six significant digits.
inline std::string number(Real value) { return number_text(value); }

/// With fixed decimals that resolve about 1/1000 of `extent`: 31.20 in a section 60 m wide.
inline std::string coordinate(Real value, Real extent) {
  if (!(extent >= 1e-9 && extent <= 1e9 && std::abs(value) <= 1e12)) return number(value);
  const int decimals = std::max(3 - static_cast<int>(std::floor(std::log10(extent))), 0);
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  return {text, end};
}

/// "(31.20, 7.05)"
inline std::string place(Real x, Real y, Real extent) {
  std::string text(1, '(');
  text += coordinate(x, extent);
  text += ", ";
  text += coordinate(y, extent);
  return text += ')';
}

}  // namespace vbgpd
