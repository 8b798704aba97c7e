// Work of plastic flow: the stress after the return, which is the one that acts, times the plastic strain.
#pragma once

#include "base/pack.h"
#include "material/cone.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

VBGPD_INLINE void add(double* p, Pack v) { store(p, load(p) + v); }

/// Per volume, of a deviatoric plastic strain (zz = -xx - yy).
VBGPD_INLINE Pack shear_work(const Stress<Pack>& s, Pack dxx, Pack dyy, Pack dxy) {
  return s.xx * (2.0 * dxx + dyy) + s.yy * (2.0 * dyy + dxx) + 2.0 * s.xy * dxy;
}

/// Of the volume by which both ends of a bond opened in this step. Keeps V_i times the mean stress for the volume that
/// the ends are going to dilate by (flux_pass). `half` is B_ij/2.
VBGPD_INLINE Pack opening_work(const StepData& d, const BondPack& pack, Pack half, Pack mean) {
  const Pack share = half * mean;
  if (d.mean_load != nullptr) add(d.mean_load + pack.i, share), add(d.mean_load + pack.j, share);
  return share * (load(d.opening + pack.i) + load(d.opening + pack.j));
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
