#include "base/parallel.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace vbgpd {

struct Workers::Pool {
  int threads = 1;
  int sessions = 0;
  std::vector<std::thread> helpers;

  // One job at a time; `generation` announces it, `pending` counts the helpers still at it.
  std::mutex mutex;
  std::condition_variable wake;
  std::atomic<unsigned> generation{0};
  std::atomic<int> pending{0};
  std::atomic<int> next{0};
  bool stop = false;
  int stride = 1, chunks = 0;
  void (*call)(void*, int) = nullptr;
  void* context = nullptr;

  void work() {
    for (int k = next.fetch_add(stride, std::memory_order_relaxed); k < chunks;
         k = next.fetch_add(stride, std::memory_order_relaxed))
      call(context, k);
  }

  void help(unsigned seen) {
    constexpr int kSpins = 4000;  // a pass takes microseconds: look a while before sleeping
    for (;;) {
      int spins = 0;
      while (generation.load(std::memory_order_acquire) == seen && spins < kSpins) ++spins;
      if (generation.load(std::memory_order_acquire) == seen) {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return generation.load(std::memory_order_acquire) != seen; });
      }
      seen = generation.load(std::memory_order_acquire);
      if (stop) return;
      work();
      pending.fetch_sub(1, std::memory_order_release);
    }
  }

  void announce() {
    {
      std::lock_guard lock(mutex);
      generation.fetch_add(1, std::memory_order_release);
    }
    wake.notify_all();
  }
};

Workers::Workers(int threads) : pool_(std::make_unique<Pool>()) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  pool_->threads = threads > 0 ? threads : (cores > 0 ? cores : 1);
}
Workers::~Workers() = default;
int Workers::threads() const { return pool_->threads; }
int Workers::team() const { return static_cast<int>(pool_->helpers.size()) + 1; }

Workers::Session::Session(Workers& workers) : workers_(workers) {
  Pool& p = *workers.pool_;
  if (p.sessions++ != 0) return;
  p.stop = false;
  const unsigned seen = p.generation.load();
  try {
    p.helpers.reserve(static_cast<std::size_t>(p.threads - 1));
    for (int t = 1; t < p.threads; ++t) p.helpers.emplace_back([&p, seen] { p.help(seen); });
  } catch (...) {  // no more threads to be had: those there are do the work, with the same bits
  }
}

Workers::Session::~Session() {
  Pool& p = *workers_.pool_;
  if (--p.sessions != 0) return;
  p.stop = true;
  p.announce();
  for (auto& helper : p.helpers) helper.join();
  p.helpers.clear();
}

void Workers::run_erased(int first, int stride, int chunks, void (*call)(void*, int), void* context) {
  Pool& p = *pool_;
  if (p.helpers.empty() || chunks - first <= stride) {
    for (int k = first; k < chunks; k += stride) call(context, k);
    return;
  }
  p.call = call;
  p.context = context;
  p.stride = stride;
  p.chunks = chunks;
  p.next.store(first, std::memory_order_relaxed);
  p.pending.store(static_cast<int>(p.helpers.size()), std::memory_order_relaxed);
  p.announce();
  p.work();
  while (p.pending.load(std::memory_order_acquire) != 0) std::this_thread::yield();
}

}  // namespace vbgpd
