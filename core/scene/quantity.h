// Numbers with their units, as the writer of a scene would put them.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene_def.h"
#include "scene/wording.h"

namespace vbgpd {

/// UDUNITS as people write it behind a number, with the space before it: "N m-3" -> " N/m3", or " kN/m3" in `units`.
inline std::string unit_text(std::string_view unit, Units units) {
  if (unit == "1") return "";
  if (unit == "degree") return " degrees";
  const bool stress = unit.starts_with("Pa") || unit.starts_with("N");
  std::string text = stress && units == Units::kKilopascal ? " k" : " ";
  const auto blank = unit.find(' ');
  text.append(unit.substr(0, blank));
  if (blank == unit.npos) return text;
  std::string below(unit.substr(blank + 1));
  std::erase(below, '-');
  if (below.back() == '1') below.pop_back();
  return text.append("/").append(below);
}

/// The number of a value of SI in `units`.
inline double in_units(double value, std::string_view unit, Units units) {
  return unit_text(unit, units).starts_with(" k") ? value / 1000 : value;
}

/// "10 kPa", "0.5 m", "20 degrees" of a value of SI.
inline std::string quantity_text(double value, std::string_view unit, Units units, int digits = 6) {
  return number_text(in_units(value, unit, units), digits) + unit_text(unit, units);
}

}  // namespace vbgpd
