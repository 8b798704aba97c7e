// Workers that live only inside a call. Work is cut into chunks whose number never depends on the thread count, and
// chunk results are combined in chunk order: same bits for any number of threads.
#pragma once

#include <memory>
#include <type_traits>

namespace vbgpd {

/// Runs one function over numbered chunks on a fixed number of threads (the caller's included).
class Workers {
 public:
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// While one lives the extra threads exist; steps inside it wake them without creating them again.
  class Session {
   public:
    explicit Session(Workers& workers);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

   private:
    Workers& workers_;
  };

  /// Calls f(k) for k = first, first + stride, ... < chunks; which thread does which chunk is not determined, what it
  /// does is. No more calls than the team has members run at once, and as many do.
  template <class F>
  void run(int first, int stride, int chunks, F&& f) {
    using Function = std::remove_reference_t<F>;
    run_erased(
        first, stride, chunks, [](void* context, int k) { (*static_cast<Function*>(context))(k); },
        const_cast<void*>(static_cast<const void*>(&f)));
  }
  int threads() const;
  int team() const;  ///< threads there are now: those of the session, else one

 private:
  void run_erased(int first, int stride, int chunks, void (*call)(void*, int), void* context);
  struct Pool;
  std::unique_ptr<Pool> pool_;
};

}  // namespace vbgpd
