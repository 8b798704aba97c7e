// The run-out step, built once per instruction set from the same source like kernels.h.
#pragma once

#include <span>
#include <string_view>

#include "base/parallel.h"
#include "step/flow_data.h"

namespace vbgpd {

using FlowStepFunction = void (*)(const FlowData&, const FlowControls&, Workers&, FlowSums* partial, FlowSums& sums);

/// Step functions by FlowBondLaw, without and with stress diffusion; the rivals are as they were published, without.
inline constexpr int kFlowBondLaws = 6;
using FlowStepTable = FlowStepFunction[kFlowBondLaws][2];

struct FlowKernels {
  std::string_view isa;
  bool supported;  ///< by this processor
  const FlowStepTable& step;
};

/// Every build in this library, best first.
std::span<const FlowKernels> all_flow_kernels();
const FlowKernels& best_flow_kernels();

}  // namespace vbgpd
