// Arrays of the model and the state: aligned, staggered, and absent when no law asks for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>

namespace vbgpd {

/// A block of doubles that is either present (n values) or absent (no bytes). Starts are staggered by odd numbers of
/// cache lines, because arrays that all begin on a page boundary evict each other (measured: 9.9 -> 17.2 M
/// particle-steps/s at 1e6).
class Array {
 public:
  Array() = default;
  Array(const Array& other) { *this = other; }
  Array(Array&&) noexcept = default;
  Array& operator=(Array&&) noexcept = default;
  Array& operator=(const Array& other) {
    if (this == &other) return *this;
    if (size_ != other.size_) allocate(other.size_, other.stagger_);
    if (size_ != 0) std::memcpy(data(), other.data(), size_ * sizeof(double));
    return *this;
  }

  /// n zeros; `stagger` is the array's number in the list of arrays. Absent when memory runs out.
  void allocate(std::size_t n, int stagger) {
    stagger_ = stagger;
    size_ = 0;
    storage_.reset();
    if (n == 0) return;
    const std::size_t shift = 64 * static_cast<std::size_t>(5 * (stagger % 13));
    bytes_ = n * sizeof(double) + shift;
    storage_.reset(static_cast<std::byte*>(::operator new (bytes_, std::align_val_t{64})));
    std::memset(storage_.get(), 0, bytes_);
    shift_ = shift;
    size_ = n;
  }
  bool present() const { return size_ != 0; }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ == 0 ? 0 : bytes_; }
  double* data() { return size_ == 0 ? nullptr : reinterpret_cast<double*>(storage_.get() + shift_); }
  const double* data() const { return const_cast<Array*>(this)->data(); }
  double& operator[](std::size_t i) { return data()[i]; }
  double operator[](std::size_t i) const { return data()[i]; }
  void fill_zero() {
    if (size_ != 0) std::memset(data(), 0, size_ * sizeof(double));
  }

 private:
  struct Free {
    void operator()(std::byte* p) const { ::operator delete (p, std::align_val_t{64}); }
  };
  std::unique_ptr<std::byte, Free> storage_;
  std::size_t size_ = 0, shift_ = 0, bytes_ = 0;
  int stagger_ = 0;
};

}  // namespace vbgpd
