#include "material_text.h"

#include <cmath>

#include "format.h"

namespace cli {

std::string material_text(const vbgpd_profile* profile, std::int64_t material) {
  const auto value = [&](const char* name) { return number(profile, VBGPD_OBJECT_MATERIAL, material, name); };
  const auto kilo = [&](const char* name) { return plain_number(value(name) / 1000, 4); };
  const std::string law = text(profile, VBGPD_OBJECT_MATERIAL, material, "law");
  std::string line = "γ " + kilo("unit_weight") + " kN/m³";
  if (std::isfinite(value("saturated_unit_weight"))) line += " (saturated " + kilo("saturated_unit_weight") + ")";
  if (value("pore_pressure_ratio") != 0) line += ", r_u " + plain_number(value("pore_pressure_ratio"), 4);
  if (law == "elastic") return line + ", elastic";
  if (law == "undrained") {
    line += ", su " + kilo("cohesion") + " kPa";
    if (value("cohesion_gradient") != 0)
      line += " + " + kilo("cohesion_gradient") + " kPa/m below y = " + plain_number(value("cohesion_datum"), 5) + " m";
    return line;
  }
  line += ", c " + kilo("cohesion") + " kPa, φ " + plain_number(value("friction_angle"), 4) + "°";
  if (value("dilatancy_angle") != 0) line += ", ψ " + plain_number(value("dilatancy_angle"), 4) + "°";
  if (std::isfinite(value("tension_cutoff"))) line += ", tension ≤ " + kilo("tension_cutoff") + " kPa";
  return law == "drucker_prager" ? line + ", Drucker-Prager" : line;
}

}  // namespace cli
