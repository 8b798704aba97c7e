// A long computation that pauses now and then: a coroutine that is resumed slice by slice.
#pragma once

#include <coroutine>
#include <exception>
#include <utility>

namespace vbgpd {

/// `co_yield Pause{}` hands control back; `next()` goes on until the next pause and is false at the end.
struct Pause {};

class Slices {
 public:
  struct promise_type {
    std::exception_ptr error;
    Slices get_return_object() { return Slices(std::coroutine_handle<promise_type>::from_promise(*this)); }
    std::suspend_always initial_suspend() noexcept { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    std::suspend_always yield_value(Pause) noexcept { return {}; }
    void return_void() {}
    void unhandled_exception() { error = std::current_exception(); }
  };
  Slices() = default;
  Slices(Slices&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Slices& operator=(Slices&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Slices() {
    if (handle_) handle_.destroy();
  }
  bool next() {
    if (!handle_ || handle_.done()) return false;
    handle_.resume();
    if (auto error = std::exchange(handle_.promise().error, nullptr)) std::rethrow_exception(error);
    return !handle_.done();
  }

 private:
  explicit Slices(std::coroutine_handle<promise_type> handle) : handle_(handle) {}
  std::coroutine_handle<promise_type> handle_;
};

}  // namespace vbgpd
