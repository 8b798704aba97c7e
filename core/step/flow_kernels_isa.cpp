// Compiled once per instruction set with VBGPD_ISA naming the inline namespace (see CMakeLists.txt).
#include "step/flow_kernels.h"
#include "step/flow_step.h"

#define VBGPD_JOIN2(a, b) a##b
#define VBGPD_JOIN(a, b) VBGPD_JOIN2(a, b)

namespace vbgpd {

extern const FlowStepTable VBGPD_JOIN(kFlowTable_, VBGPD_ISA);
const FlowStepTable VBGPD_JOIN(kFlowTable_, VBGPD_ISA) = {
    {&flow_step<VirtualBonds, false>, &flow_step<VirtualBonds, true>},
    {&flow_step<CorrectedSph, false>, &flow_step<CorrectedSph, true>},
    {&flow_step<PlainSph, false>, nullptr},
    {&flow_step<ArtificialStress, false>, nullptr},
    {&flow_step<PseudoSprings, false>, nullptr},
    {&flow_step<LifeAndDeath, false>, nullptr},
};

}  // namespace vbgpd
