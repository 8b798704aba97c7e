// Hiding lanes: a pack may hold bonds that were cut or belong to another pair of materials.
#pragma once

#include "base/pack.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

VBGPD_INLINE Mask lane_mask(std::uint8_t lanes) {
  Mask m;
  for (int l = 0; l < kWidth; ++l) m[l] = (lanes >> l) & 1 ? -1 : 0;
  return m;
}

/// v where the lane is shown, 0 elsewhere.
VBGPD_INLINE Pack visible(Pack v, std::uint8_t lanes) {
  return lanes == 0xff ? v : select(lane_mask(lanes), v, Pack{});
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
