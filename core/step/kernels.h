// The step, built once per instruction set from the same source; the best one this processor has is chosen once per
// process.
#pragma once

#include <span>
#include <string_view>

#include "base/parallel.h"
#include "step/step_data.h"

namespace vbgpd {

using StepFunction = void (*)(const StepData&, const Controls&, Workers&, Sums* partial, Sums& sums);

/// [virtual bonds][off the lattice][ledger]
using StepTable = StepFunction[2][2][2];

struct Kernels {
  std::string_view isa;  ///< "x86-64-v2", "x86-64-v3", "x86-64-v4", "portable"
  int width;             ///< lanes of a pack
  bool supported;        ///< by this processor
  const StepTable* table;
  StepFunction step(bool bonded, bool off_lattice, bool ledger) const {
    return (*table)[bonded ? 1 : 0][off_lattice ? 1 : 0][ledger ? 1 : 0];
  }
};

/// Every build of the step in this library, best first.
std::span<const Kernels> all_kernels();
/// The best supported one.
const Kernels& best_kernels();

}  // namespace vbgpd
