// Compiled once per instruction set with VBGPD_ISA naming the inline namespace (see CMakeLists.txt).
#include "step/kernels.h"
#include "step/step.h"

#define VBGPD_JOIN2(a, b) a##b
#define VBGPD_JOIN(a, b) VBGPD_JOIN2(a, b)

namespace vbgpd {

extern const StepTable VBGPD_JOIN(kStepTable_, VBGPD_ISA);
const StepTable VBGPD_JOIN(kStepTable_, VBGPD_ISA) = {
    {{&step<NoBonds, OnLattice, false>, &step<NoBonds, OnLattice, true>},
     {&step<NoBonds, OffLattice, false>, &step<NoBonds, OffLattice, true>}},
    {{&step<SelectiveVirtualBonds, OnLattice, false>, &step<SelectiveVirtualBonds, OnLattice, true>},
     {&step<SelectiveVirtualBonds, OffLattice, false>, &step<SelectiveVirtualBonds, OffLattice, true>}}};
extern const int VBGPD_JOIN(kStepWidth_, VBGPD_ISA);
const int VBGPD_JOIN(kStepWidth_, VBGPD_ISA) = kWidth;

}  // namespace vbgpd
