// Pressure of the pore water of a run-out. It is set from outside and goes with its particle; where the soil has come
// apart, water that cannot follow expands with the gap and loses it.
#pragma once

#include "step/flow_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// max(p - K gap, 0): as stiff as the skeleton, so that soil without effective stress is unloaded as it would be with
/// it, by a force that has a potential. Suction stays. Pa, compression positive
VBGPD_INLINE double water_pressure(double set, double bulk_modulus, double gap) {
  return set > 0 ? larger(set - bulk_modulus * gap, 0) : set;
}

/// Of particle i, with its present gap; 0 where there is no water.
VBGPD_INLINE double water_pressure(const FlowData& d, const FlowControls& c, int i) {
  if (d.pore_pressure == nullptr) return 0;
  return water_pressure(d.pore_pressure[i], c.laws[d.soil[i]].constants.bulk_modulus, d.gap[i]);
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
