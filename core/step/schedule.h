// In which order the passes of a step visit the chunks. Each pass of a chunk needs the pass before of the chunk and of
// its two neighbours; bonds write to their own chunk and the next one. Even chunks before odd ones in the pass over
// bonds, whatever the order otherwise: same sums, same bits.
#pragma once

#include <atomic>
#include <thread>

#include "base/pack.h"
#include "base/parallel.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

enum Pass { kWeigh, kGradient, kBonds, kFlux, kMove, kPasses };

template <class Weigh, class Gradient, class Bonds, class Flux, class Move>
struct Passes {
  Weigh weigh;
  Gradient gradient;
  Bonds bonds;
  Flux flux;
  Move move;

  void run(Pass pass, int k) const {
    switch (pass) {
      case kWeigh:
        return weigh(k);
      case kGradient:
        return gradient(k);
      case kBonds:
        return bonds(k);
      case kFlux:
        return flux(k);
      case kMove:
        return move(k);
      case kPasses:
        return;
    }
  }
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

/// One wave through the chunks [first, last) on one thread, upwards: every pass follows the one before at the distance
/// it needs, while what they share is still in cache. `first` is even.
template <class Do>
void wave_up(int first, int last, const Do& at) {
  for (int k = first; k < last + 4; k += 2) {
    at(kWeigh, k), at(kWeigh, k + 1);
    at(kGradient, k - 1), at(kGradient, k);
    at(kBonds, k - 2), at(kBonds, k - 3);
    at(kFlux, k - 3), at(kFlux, k - 2);
    at(kMove, k - 4), at(kMove, k - 3);
  }
}
/// The same downwards; `last` is even or the number of chunks.
template <class Do>
void wave_down(int first, int last, const Do& at) {
  for (int k = last + last % 2 - 1; k >= first - 4; k -= 2) {
    at(kWeigh, k), at(kWeigh, k - 1);
    at(kGradient, k + 1), at(kGradient, k);
    at(kBonds, k + 1), at(kBonds, k + 2);
    at(kFlux, k + 3), at(kFlux, k + 2);
    at(kMove, k + 4), at(kMove, k + 3);
  }
}

template <class P>
void in_a_wave(int chunks, const P& passes) {
  wave_up(0, chunks, [&](Pass pass, int k) {
    if (k >= 0 && k < chunks) passes.run(pass, k);
  });
}

/// What the first and the last chunk of a thread have done in this step: the next thread's border waits for it.
struct alignas(64) Border {
  std::atomic<bool> done[kPasses] = {};
  void await(Pass pass) const {
    for (int spins = 0; !done[pass].load(std::memory_order_acquire);)
      if (++spins > kSpins) std::this_thread::yield();
  }
  static constexpr int kSpins = 4000;
};

/// A wave on every thread through its own share of the chunks, in turns upwards and downwards, so that neighbours reach
/// a common border at the same time and there wait for each other, pass by pass. A pass waits for earlier ones only, so
/// that somebody can always go on.
template <class P>
void in_waves(Workers& workers, int chunks, int shares, const P& passes) {
  constexpr int kMost = 32;
  if (shares > kMost) shares = kMost;
  Border low[kMost], high[kMost];
  workers.run(0, 1, shares, [&](int n) {
    const auto begin = [&](int m) {
      return m == shares ? chunks : static_cast<int>(2l * (chunks / 2) * m / shares) & ~1;
    };
    const int first = begin(n), last = begin(n + 1);
    const auto at = [&](Pass pass, int k) {
      if (k < first || k >= last) return;
      const bool lowest = k == first, highest = k == last - 1;
      const Pass before = static_cast<Pass>(pass - 1);
      if (lowest && n > 0 && pass > kWeigh) high[n - 1].await(before);
      // A highest chunk is odd: its bonds come after those of the even one above, its flux waits for nothing new.
      if (highest && n + 1 < shares && pass > kWeigh && pass != kFlux) low[n + 1].await(before);
      if (highest && n + 1 < shares && pass == kBonds) low[n + 1].await(kBonds);
      passes.run(pass, k);
      if (lowest) low[n].done[pass].store(true, std::memory_order_release);
      if (highest) high[n].done[pass].store(true, std::memory_order_release);
    };
    if (n % 2 == 0) wave_up(first, last, at);
    else wave_down(first, last, at);
  });
}

/// Fewer chunks than this for each thread are not worth a wave.
inline constexpr int kShare = 8;

template <class P>
void in_order(Workers& workers, int chunks, const P& passes) {
  const int team = workers.team(), shares = chunks / kShare < team ? chunks / kShare : team;
  if (team == 1) in_a_wave(chunks, passes);
  else if (shares > 1) in_waves(workers, chunks, shares, passes);
  else in_sweeps(workers, chunks, passes);
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
