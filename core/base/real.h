// The number types, without any library.
#pragma once

#include <cstdint>

namespace vbgpd {

using Real = double;
using Index = std::int32_t;

inline constexpr Real kPi = 3.14159265358979323846;
inline constexpr Real radians(Real degrees) { return degrees * (kPi / 180); }

}  // namespace vbgpd
