#include "step/flow_kernels.h"

#include "step/processor.h"

namespace vbgpd {

extern const FlowStepTable kFlowTable_portable, kFlowTable_x86_64_v2, kFlowTable_x86_64_v3;

std::span<const FlowKernels> all_flow_kernels() {
  static const FlowKernels list[] = {
#if defined(VBGPD_HAS_x86_64_v3)
    {"x86-64-v3", has_x86_64_v3(), kFlowTable_x86_64_v3},
#endif
#if defined(VBGPD_HAS_x86_64_v2)
    {"x86-64-v2", has_x86_64_v2(), kFlowTable_x86_64_v2},
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
