#include "step/kernels.h"

#include "step/processor.h"

namespace vbgpd {

extern const StepTable kStepTable_portable;
extern const int kStepWidth_portable;
extern const StepTable kStepTable_x86_64_v2, kStepTable_x86_64_v3, kStepTable_x86_64_v4;
extern const int kStepWidth_x86_64_v2, kStepWidth_x86_64_v3, kStepWidth_x86_64_v4;

std::span<const Kernels> all_kernels() {
  static const Kernels list[] = {
#if defined(VBGPD_HAS_x86_64_v4)
    {"x86-64-v4", kStepWidth_x86_64_v4, has_x86_64_v4(), &kStepTable_x86_64_v4},
#endif
#if defined(VBGPD_HAS_x86_64_v3)
    {"x86-64-v3", kStepWidth_x86_64_v3, has_x86_64_v3(), &kStepTable_x86_64_v3},
#endif
#if defined(VBGPD_HAS_x86_64_v2)
    {"x86-64-v2", kStepWidth_x86_64_v2, has_x86_64_v2(), &kStepTable_x86_64_v2},
#endif
    {"portable", kStepWidth_portable, true, &kStepTable_portable}
  };
  return list;
}

const Kernels& best_kernels() {
  for (const Kernels& k : all_kernels())
    if (k.supported) return k;
  return all_kernels().back();
}

}  // namespace vbgpd
