// Arrays of the model and the state: aligned, staggered, and absent when no law asks for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "base/heap.h"

namespace vbgpd {

/// A block of doubles that is either present (n values) or absent (no bytes). Starts are staggered by odd numbers of
/// cache lines, because arrays that all begin on a page boundary evict each other (measured: 9.9 -> 17.2 M
/// particle-steps/s at 1e6).
class Array {
 public:
  Array() = default;
  Array(const Array& other) { *this = other; }
  Array(Array&& other) noexcept { exchange(other); }
  Array& operator=(Array&& other) noexcept {
    Array taken(std::move(other));
    exchange(taken);
    return *this;
  }
  /// A copy comes from the heap of what it is a copy of, unless its size was right already.
  Array& operator=(const Array& other) {
    if (this == &other) return *this;
    if (size_ != other.size_) allocate_for_overwrite(other.size_, other.stagger_, other.heap_);
    if (size_ != 0) std::memcpy(data(), other.data(), size_ * sizeof(double));
    return *this;
  }
  ~Array() { release(); }

  /// n zeros; `stagger` is the array's number in the list of arrays. Absent when memory runs out.
  void allocate(std::size_t n, int stagger, const Heap& heap = {}) {
    allocate_for_overwrite(n, stagger, heap);
    fill_zero();
  }
  /// n values that are yet to be written.
  void allocate_for_overwrite(std::size_t n, int stagger, const Heap& heap = {}) {
    release();
    stagger_ = stagger;
    if (n == 0) return;
    const std::size_t shift = n < kLong ? 0 : 64 * static_cast<std::size_t>(5 * (stagger % 13));
    const std::size_t bytes = n * sizeof(double) + shift;
    storage_ = static_cast<std::byte*>(heap.take(bytes));
    heap_ = heap, bytes_ = bytes, shift_ = shift, size_ = n;
  }
  bool present() const { return size_ != 0; }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ == 0 ? 0 : bytes_; }
  double* data() { return size_ == 0 ? nullptr : reinterpret_cast<double*>(storage_ + shift_); }
  const double* data() const { return const_cast<Array*>(this)->data(); }
  double& operator[](std::size_t i) { return data()[i]; }
  double operator[](std::size_t i) const { return data()[i]; }
  void fill_zero() {
    if (size_ != 0) std::memset(data(), 0, size_ * sizeof(double));
  }

 private:
  static constexpr std::size_t kLong = 8192;  // shorter ones share pages and are where the heap happened to put them
  void release() noexcept {
    if (storage_ != nullptr) heap_.give_back(storage_, bytes_);
    storage_ = nullptr, size_ = 0;
  }
  void exchange(Array& other) noexcept {
    std::swap(storage_, other.storage_), std::swap(size_, other.size_), std::swap(shift_, other.shift_);
    std::swap(bytes_, other.bytes_), std::swap(stagger_, other.stagger_), std::swap(heap_, other.heap_);
  }

  std::byte* storage_ = nullptr;
  std::size_t size_ = 0, shift_ = 0, bytes_ = 0;
  int stagger_ = 0;
  Heap heap_;
};

}  // namespace vbgpd
