// Compiled once per instruction set with VBGPD_ISA naming the inline namespace (see CMakeLists.txt).
#include "step/kernels.h"
#include "step/step.h"

#define VBGPD_JOIN2(a, b) a##b
#define VBGPD_JOIN(a, b) VBGPD_JOIN2(a, b)

namespace vbgpd {

extern const StepFunction VBGPD_JOIN(kStepTable_, VBGPD_ISA)[4];

const StepFunction VBGPD_JOIN(kStepTable_, VBGPD_ISA)[4] = {&step<SelectiveVirtualBonds, false>,
                                                            &step<SelectiveVirtualBonds, true>, &step<NoBonds, false>,
                                                            &step<NoBonds, true>};
extern const int VBGPD_JOIN(kStepWidth_, VBGPD_ISA);
const int VBGPD_JOIN(kStepWidth_, VBGPD_ISA) = kWidth;

}  // namespace vbgpd
