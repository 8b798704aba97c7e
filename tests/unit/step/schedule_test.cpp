#include "step/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vbgpd {
namespace {

/// Passes that do nothing but look whether what they need has been done.
class Watched {
 public:
  explicit Watched(int chunks) : chunks_(chunks), done_(static_cast<std::size_t>(kPasses * chunks)) {}

  void run(Pass pass, int k) {
    const auto done_around = [&](Pass before, int reach) {
      for (int j = std::max(0, k - reach); j <= std::min(chunks_ - 1, k + reach); ++j) need(before, j);
    };
    if (pass == kGradient) done_around(kWeigh, 1);
    if (pass == kBonds) {
      done_around(kGradient, 1);
      if (k % 2 == 1) need(kBonds, k - 1);
      if (k % 2 == 1 && k + 1 < chunks_) need(kBonds, k + 1);
    }
    if (pass == kFlux) {  // bonds write to their own chunk and the next one
      need(kBonds, k);
      if (k > 0) need(kBonds, k - 1);
    }
    if (pass == kMove) done_around(kFlux, 1);
    if (at(pass, k).fetch_add(1, std::memory_order_acq_rel) != 0) ++faults_;
  }

  bool whole() const {
    return faults_ == 0 && std::all_of(done_.begin(), done_.end(), [](const auto& d) { return d.load() == 1; });
  }

 private:
  std::atomic<int>& at(Pass pass, int k) { return done_[static_cast<std::size_t>(pass * chunks_ + k)]; }
  void need(Pass pass, int k) {
    if (at(pass, k).load(std::memory_order_acquire) != 1) ++faults_;
  }
  int chunks_;
  std::vector<std::atomic<int>> done_;
  std::atomic<int> faults_{0};
};

auto passes_of(Watched& w) {
  return Passes{[&w](int k) { w.run(kWeigh, k); }, [&w](int k) { w.run(kGradient, k); },
                [&w](int k) { w.run(kBonds, k); }, [&w](int k) { w.run(kFlux, k); }, [&w](int k) { w.run(kMove, k); }};
}

TEST(Schedule, DoesEveryPassOfEveryChunkOnceAndAfterWhatItNeeds) {
  for (int threads : {1, 2, 3, 4, 5}) {
    Workers workers(threads);
    const Workers::Session session(workers);
    for (int chunks = 1; chunks <= 64; ++chunks) {
      Watched w(chunks);
      in_order(workers, chunks, passes_of(w));
      EXPECT_TRUE(w.whole()) << chunks << " chunks, " << threads << " threads";
    }
  }
}

TEST(Schedule, WorksWithoutASessionToo) {
  Workers workers(4);  // whose helpers do not live yet
  Watched w(40);
  in_order(workers, 40, passes_of(w));
  EXPECT_TRUE(w.whole());
}

TEST(Schedule, SharesBetweenMoreThreadsThanCores) {
  Workers workers(40);
  const Workers::Session session(workers);
  Watched w(40 * kShare);
  in_order(workers, 40 * kShare, passes_of(w));
  EXPECT_TRUE(w.whole());
}

}  // namespace
}  // namespace vbgpd
