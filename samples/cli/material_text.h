// The parameters of a material in the units engineers write.
#pragma once

#include <string>

#include "engine.h"

namespace cli {

/// "γ 20 kN/m³, c 10 kPa, φ 20°, ψ 5°"
std::string material_text(const vbgpd_profile* profile, std::int64_t material);

}  // namespace cli
