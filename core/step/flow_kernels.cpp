#include "step/flow_kernels.h"

namespace vbgpd {

extern const FlowStepTable kFlowTable_portable, kFlowTable_x86_64_v2, kFlowTable_x86_64_v3;

std::span<const FlowKernels> all_flow_kernels() {
  static const FlowKernels list[] = {
#if defined(VBGPD_HAS_x86_64_v3)
    {"x86-64-v3",
     __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2"),
     kFlowTable_x86_64_v3},
#endif
#if defined(VBGPD_HAS_x86_64_v2)
    {"x86-64-v2", __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt"), kFlowTable_x86_64_v2},
#endif
    {"portable", true, kFlowTable_portable}
  };
  return list;
}

const FlowKernels& best_flow_kernels() {
  for (const FlowKernels& k : all_flow_kernels())
    if (k.supported) return k;
  return all_flow_kernels().back();
}

}  // namespace vbgpd
