// Compiled once per instruction set with VBGPD_ISA naming the inline namespace (see CMakeLists.txt).
#include "step/flow_kernels.h"
#include "step/flow_step.h"

#define VBGPD_JOIN2(a, b) a##b
#define VBGPD_JOIN(a, b) VBGPD_JOIN2(a, b)

namespace vbgpd {

extern const FlowStepFunction VBGPD_JOIN(kFlowTable_, VBGPD_ISA)[2];
const FlowStepFunction VBGPD_JOIN(kFlowTable_, VBGPD_ISA)[2] = {&flow_step<false>, &flow_step<true>};

}  // namespace vbgpd
