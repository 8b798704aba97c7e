#include "step/kernels.h"

namespace vbgpd {

extern const StepFunction kStepTable_portable[4];
extern const int kStepWidth_portable;
#if defined(VBGPD_X86)
extern const StepFunction kStepTable_x86_64_v2[4], kStepTable_x86_64_v3[4], kStepTable_x86_64_v4[4];
extern const int kStepWidth_x86_64_v2, kStepWidth_x86_64_v3, kStepWidth_x86_64_v4;
#endif

namespace {

Kernels entry(std::string_view isa, int width, bool supported, const StepFunction* table) {
  return {isa, width, supported, table[0], table[1], table[2], table[3]};
}

}  // namespace

std::span<const Kernels> all_kernels() {
  static const Kernels list[] = {
#if defined(VBGPD_X86)
    entry("x86-64-v4", kStepWidth_x86_64_v4,
          __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
              __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"),
          kStepTable_x86_64_v4),
    entry("x86-64-v3", kStepWidth_x86_64_v3,
          __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"),
          kStepTable_x86_64_v3),
    entry("x86-64-v2", kStepWidth_x86_64_v2, __builtin_cpu_supports("sse4.2"), kStepTable_x86_64_v2),
#endif
    entry("portable", kStepWidth_portable, true, kStepTable_portable)
  };
  return list;
}

const Kernels& best_kernels() {
  for (const Kernels& k : all_kernels())
    if (k.supported) return k;
  return all_kernels().back();
}

}  // namespace vbgpd
