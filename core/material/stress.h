// Stress of plane strain, split into mean and deviator. Tension positive; m = (xx + yy + zz)/3, so m = -p.
#pragma once

#include "base/pack.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// sigma = s + m I with s_zz = -(s_xx + s_yy). R is double or Pack.
template <class R>
struct Stress {
  R xx, yy, xy;  ///< in-plane deviator, Pa
  R m;           ///< mean stress, Pa, tension positive
  VBGPD_INLINE R zz() const { return -(xx + yy); }
  /// Second invariant of the deviator, J2 = s:s/2.
  VBGPD_INLINE R j2() const { return xx * xx + yy * yy + xx * yy + xy * xy; }
};

/// What a return mapping did: the stress on the yield surface and where it moved anything.
template <class R>
struct Returned {
  Stress<R> stress;
  R dilated;  ///< plastic volumetric strain of dilatant shear, >= 0; opening in tension is the particle's
              ///< (step/gradient.h)
  bool any;   ///< true when at least one lane yielded
};

/// A trial stress returned to a surface (cone.h, hexagon.h) of its own strength k, where it yields.
template <class Surface, class R>
VBGPD_INLINE Returned<R> return_to(const Surface& surface, const Stress<R>& trial) {
  const typename Surface::Look looked = surface.look(trial, surface.k);
  if (!any(looked.yields)) return {trial, R{}, false};
  return surface.returned(trial, looked, surface.k);
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
