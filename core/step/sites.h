// Where the ends of bonds are: on a lattice all lanes of a pack share one offset, off it every bond has its own place
// and weight. A pass takes either as `Sites`.
#pragma once

#include "base/pack.h"
#include "step/lanes.h"
#include "step/step_data.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

struct OnLattice {
  using Bond = const Offset*;
  VBGPD_INLINE static Bond bond(const StepData& d, const BondPack& pack) { return d.offsets + pack.offset; }

  /// omega_ij xi of neighbour pack n of the block that begins with particle i; 0 where a lane is no neighbour.
  VBGPD_INLINE static void operator_of(const StepData& d, int n, const Block&, Pack& gx, Pack& gy) {
    const NeighbourPack& neighbour = d.neighbours[n];
    const Offset& o = d.offsets[neighbour.offset];
    gx = visible(broadcast(o.g_x), neighbour.lanes), gy = visible(broadcast(o.g_y), neighbour.lanes);
  }
};

struct OffLattice {
  struct Offset {
    Pack half_x, half_y, twice_n_x, twice_n_y, half_weight, pull;
    const Offset* operator->() const { return this; }
  };
  using Bond = Offset;
  VBGPD_INLINE static Bond bond(const StepData& d, const BondPack& p) {
    const Pack x = load(d.place_x + p.j) - load(d.place_x + p.i), y = load(d.place_y + p.j) - load(d.place_y + p.i);
    const Pack twice = 2.0 / larger(x * x + y * y, broadcast(d.least_r2));
    const Pack weight = load(d.pair_weight + static_cast<long>(kWidth) * p.slot);
    return {0.5 * x, 0.5 * y, x * twice, y * twice, 0.5 * weight, twice + twice};
  }
  VBGPD_INLINE static void operator_of(const StepData& d, int n, const Block& block, Pack& gx, Pack& gy) {
    const int i = block.first, j = d.neighbours[n].j;
    const Pack weight = load(d.pair_weight + static_cast<long>(kWidth) * weight_record(block, n, d.forward_packs));
    gx = weight * (load(d.place_x + j) - load(d.place_x + i)),
    gy = weight * (load(d.place_y + j) - load(d.place_y + i));
  }
};

}  // namespace VBGPD_ISA
}  // namespace vbgpd
