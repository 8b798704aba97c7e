// A checkpoint: refused, or a model that goes on.
#include "exchange/checkpoint.h"
#include "simulation/simulation.h"
#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const vbgpd::Checkpoint checkpoint = vbgpd::checkpoint_from_bytes({data, size});
    vbgpd::CompileOptions options;
    options.spacing_factor = checkpoint.spacing_factor;
    options.lattice_multiple = checkpoint.lattice_multiple;
    options.coarsening = checkpoint.coarsening;
    const auto simulation = vbgpd::Simulation::restored(checkpoint.scene, options, checkpoint.state);
    simulation->step(1, nullptr);
    simulation->image();
  } catch (const vbgpd::Error&) {
  }
  return 0;
}
