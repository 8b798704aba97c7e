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
  static constexpr std::size_t kAlignment = 64;  ///< of every block: a cache line, as packs are read
  void* (*alloc)(void* user, std::int64_t bytes, std::int64_t alignment) = nullptr;  ///< null: operator new
  void (*free)(void* user, void* p, std::int64_t bytes, std::int64_t alignment) = nullptr;
  void* user = nullptr;

  void* take(std::size_t bytes) const {
    if (alloc == nullptr) return ::operator new (bytes, std::align_val_t{kAlignment});
    void* const p = alloc(user, static_cast<std::int64_t>(bytes), kAlignment);
    if (p == nullptr) throw std::bad_alloc();
    if (reinterpret_cast<std::uintptr_t>(p) % kAlignment == 0) return p;
    give_back(p, bytes);
    throw Error(Status::kArgument, "the alloc of the context returned memory that is not aligned to the " +
                                       std::to_string(kAlignment) + " bytes it was asked for");
  }
  void give_back(void* p, std::size_t bytes) const noexcept {
    if (alloc == nullptr) ::operator delete (p, std::align_val_t{kAlignment});
    else free(user, p, static_cast<std::int64_t>(bytes), kAlignment);
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

  Heap heap;
  HeapAllocator() = default;
  explicit HeapAllocator(const Heap& of) : heap(of) {}
  template <class U>
  HeapAllocator(const HeapAllocator<U>& other) : heap(other.heap) {}
  T* allocate(std::size_t n) { return static_cast<T*>(heap.take(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) noexcept { heap.give_back(p, n * sizeof(T)); }
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
