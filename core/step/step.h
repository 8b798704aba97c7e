// One step of virtual-bond general particle dynamics (core/README.md, "The step"; total-Lagrangian: bonds are fixed).
#pragma once

#include "base/parallel.h"
#include "step/bonds.h"
#include "step/forces.h"
#include "step/gradient.h"
#include "step/particles.h"
#include "step/schedule.h"
#include "step/walls.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

/// Bonds of a chunk: strain rate split, trial stress, return to the yield surface, plastic mark, stress sums (VB3-VB5).
struct SelectiveVirtualBonds {
  template <class Sites, template <class> class Law, bool kLedger>
  static double pass(const StepData& d, const Controls& c, const Chunk& chunk) {
    return bond_pass<Sites, Law, kLedger>(d, c, chunk);
  }
};
/// No bonds: the particles themselves yield.
struct NoBonds {
  template <class Sites, template <class> class Law, bool kLedger>
  static double pass(const StepData& d, const Controls& c, const Chunk& chunk) {
    return particle_pass<Law, kLedger>(d, c, chunk);
  }
};

/// The whole step. Chunks are summed in their own order: same bits for any thread count.
template <class Bonds, class Sites, bool kLedger>
void step(const StepData& d, const Controls& c, Workers& workers, Sums* partial, Sums& sums) {
  const int chunks = d.chunk_count;

  // particle displacement gradients                                                        VB1, VB2
  const auto weigh = [&](int k) { weigh_pass(d, d.chunks[k]); };
  const auto gradient = [&](int k) { gradient_pass<Sites, kLedger>(d, c, d.chunks[k]); };

  // bonds: strains, trial stress, yielding, sums over bonds                                VB3, VB4, VB5
  const auto bonds = [&](int k) {
    static_assert(kReturnAlgorithms == 2, "every return algorithm has a pass of its own");
    partial[k].plastic_work = 0;
    if (d.uses_algorithm[0]) partial[k].plastic_work += Bonds::template pass<Sites, Cone, kLedger>(d, c, d.chunks[k]);
    if (d.uses_algorithm[1])
      partial[k].plastic_work += Bonds::template pass<Sites, Hexagon, kLedger>(d, c, d.chunks[k]);
  };

  // forces from virtual power, gravity, loads, damping; integrate; monitors                VB5
  const auto flux = [&](int k) { partial[k].plastic_work += flux_pass<kLedger>(d, d.chunks[k]); };
  const auto move = [&](int k) {
    const double plastic_work = partial[k].plastic_work;
    partial[k] = move_pass<Sites, kLedger>(d, c, d.chunks[k]);
    partial[k].plastic_work = plastic_work;
  };

  in_order(workers, chunks, Passes{weigh, gradient, bonds, flux, move});

  // walls that slide or are moved
  guide_walls(d, c);

  sums = Sums{};
  for (int k = 0; k < chunks; ++k) {
    const Sums& s = partial[k];
    sums.unbalanced += s.unbalanced, sums.power += s.power, sums.external_power += s.external_power;
    sums.displacement2 = larger(sums.displacement2, s.displacement2),
    sums.velocity2 = larger(sums.velocity2, s.velocity2);
    sums.external_work += s.external_work, sums.internal_work += s.internal_work;
    sums.damping_work += s.damping_work, sums.plastic_work += s.plastic_work;
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
