// One step of the run-out side: the same method as step.h, updated-Lagrangian, with operators at the present positions
// and bonds that come and go with the neighbours (VB-H), or one of its rivals.
#pragma once

#include "base/parallel.h"
#include "step/flow_bonds.h"
#include "step/flow_motion.h"
#include "step/flow_strain.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Every pass writes to its own particle only: any thread may take any chunk, sums are combined in chunk order.
/// PairLaw: flow_pair_laws.h. kDiffuse: stress diffusion, wanted as soon as anything yields.
template <class PairLaw, bool kDiffuse>
void flow_step(const FlowData& d, const FlowControls& c, Workers& workers, FlowSums* partial, FlowSums& sums) {
  const int chunks = (d.particles + d.chunk - 1) / d.chunk;
  const auto each = [&](auto&& pass) {
    workers.run(0, 1, chunks, [&](int k) {
      const int first = k * d.chunk, last = first + d.chunk < d.particles ? first + d.chunk : d.particles;
      pass(first, last, partial[k]);
    });
  };
  for (int k = 0; k < chunks; ++k) partial[k] = FlowSums{};

  // mirror images behind the walls
  place_ghosts(d);
  // operators, velocity gradient, stress: gap memory, rotation, elastic, cut-off, return to the yield surface
  each([&](int first, int last, FlowSums& s) { strain_pass<PairLaw, kDiffuse>(d, c, first, last, s); });
  // virtual bonds: traction turned, loaded, relaxed by plastic flow; stress flux; gradient of the stress
  each([&](int first, int last, FlowSums& s) { bond_pass<PairLaw, kDiffuse>(d, c, first, last, s); });
  // conjugate stress of the mirror images
  press_ghosts(d, c);
  // forces from virtual power, viscosity, guard, contact with walls, gravity and loads; kick, drift; stress diffusion
  each([&](int first, int last, FlowSums& s) { motion_pass<PairLaw, kDiffuse>(d, c, first, last, s); });

  sums = FlowSums{};
  for (int k = 0; k < chunks; ++k) sums.add(partial[k]);
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
