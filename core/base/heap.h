// Where big blocks of memory come from: operator new, or functions of the host.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "base/error.h"

namespace vbgpd {

/// Held by value by everything that has memory of it: nobody needs to outlive anybody.
struct Heap {
  void* (*alloc)(void* user, std::int64_t bytes, std::int64_t alignment) = nullptr;  ///< null: operator new
  void (*free)(void* user, void* p, std::int64_t bytes, std::int64_t alignment) = nullptr;
  void* user = nullptr;

  void* take(std::size_t bytes, std::size_t alignment) const {
    if (alloc == nullptr) return ::operator new (bytes, std::align_val_t{alignment});
    void* const p = alloc(user, static_cast<std::int64_t>(bytes), static_cast<std::int64_t>(alignment));
    if (p == nullptr) throw std::bad_alloc();
    if (reinterpret_cast<std::uintptr_t>(p) % alignment == 0) return p;
    give_back(p, bytes, alignment);
    throw Error(Status::kArgument, "the alloc of the context returned memory that is not aligned to the " +
                                       std::to_string(alignment) + " bytes it was asked for");
  }
  void give_back(void* p, std::size_t bytes, std::size_t alignment) const noexcept {
    if (alloc == nullptr) ::operator delete (p, std::align_val_t{alignment});
    else free(user, p, static_cast<std::int64_t>(bytes), static_cast<std::int64_t>(alignment));
  }
  bool operator==(const Heap&) const = default;
};

/// The same for containers of the standard library; they carry it along when they are copied, moved or exchanged.
template <class T>
struct HeapAllocator {
  using value_type = T;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  static constexpr std::size_t kAlignment = 64;  // of a cache line, as packs are read

  Heap heap;
  HeapAllocator() = default;
  explicit HeapAllocator(const Heap& of) : heap(of) {}
  template <class U>
  HeapAllocator(const HeapAllocator<U>& other) : heap(other.heap) {}
  T* allocate(std::size_t n) { return static_cast<T*>(heap.take(n * sizeof(T), kAlignment)); }
  void deallocate(T* p, std::size_t n) noexcept { heap.give_back(p, n * sizeof(T), kAlignment); }
  bool operator==(const HeapAllocator&) const = default;
};

template <class T>
using List = std::vector<T, HeapAllocator<T>>;

/// An empty list that takes its memory from there.
template <class T>
void use(List<T>& list, const Heap& heap) {
  list = List<T>(HeapAllocator<T>(heap));
}

}  // namespace vbgpd
