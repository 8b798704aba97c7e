// In which order the passes of a step visit the chunks. Each pass of a chunk needs the pass before of the chunk and of
// its two neighbours; bonds write to their own chunk and the next one. Even chunks before odd ones in the pass over
// bonds, whatever the order otherwise: same sums, same bits.
#pragma once

#include "base/parallel.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

template <class Weigh, class Gradient, class Bonds, class Flux, class Move>
struct Passes {
  Weigh weigh;
  Gradient gradient;
  Bonds bonds;
  Flux flux;
  Move move;
};

/// Pass after pass over all chunks, on any number of threads.
template <class P>
void in_sweeps(Workers& workers, int chunks, const P& passes) {
  workers.run(0, 1, chunks, passes.weigh);
  workers.run(0, 1, chunks, passes.gradient);
  workers.run(0, 2, chunks, passes.bonds);
  workers.run(1, 2, chunks, passes.bonds);
  workers.run(0, 1, chunks, passes.flux);
  workers.run(0, 1, chunks, passes.move);
}

/// One wave through the chunks on one thread: every pass follows the one before at the distance it needs, while what
/// they share is still in cache.
template <class P>
void in_a_wave(int chunks, const P& passes) {
  const auto at = [chunks](const auto& pass, int k) {
    if (k >= 0 && k < chunks) pass(k);
  };
  for (int k = 0; k < chunks + 4; k += 2) {
    at(passes.weigh, k), at(passes.weigh, k + 1);
    at(passes.gradient, k - 1), at(passes.gradient, k);
    at(passes.bonds, k - 2), at(passes.bonds, k - 3);
    at(passes.flux, k - 3), at(passes.flux, k - 2);
    at(passes.move, k - 4), at(passes.move, k - 3);
  }
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
