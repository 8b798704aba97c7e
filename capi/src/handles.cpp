#include "handles.h"

#include <array>
#include <thread>

namespace vbgpd::capi {
namespace {

// A handle, from bit 0: 1 (odd), slot, generation.
constexpr int kSlotBits = 16;
constexpr int kHandleBits = sizeof(std::uintptr_t) >= 8 ? 47 : 32;
constexpr std::uint64_t kSlots = std::uint64_t{1} << kSlotBits;
constexpr std::uint64_t kLastGeneration = (std::uint64_t{1} << (kHandleBits - kSlotBits - 1)) - 1;

// A slot's word, from bit 0: pins, dying, kind, generation. One atomic, so a look-up is one compare-and-swap.
constexpr std::uint64_t kPinMask = 0xffff;
constexpr std::uint64_t kDying = std::uint64_t{1} << 16;
constexpr int kKindShift = 17;
constexpr std::uint64_t kKindMask = 0xf;
constexpr int kGenerationShift = 21;
constexpr std::uint64_t kFree = 0, kReserved = 15;  // besides the numbers of ObjectKind

struct Slot {
  std::atomic<std::uint64_t> word;
  std::atomic<Object*> object;
};

static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "cancel must be safe in a signal handler");
static_assert(std::is_trivially_destructible_v<Slot>, "handles must survive static destruction");

// Zero-initialised, hence no constructor at load time and no memory for slots never used.
constinit std::array<Slot, kSlots> slots{};
constinit std::atomic<std::uint64_t> next_slot{0};

constexpr std::uint64_t generation_of(std::uint64_t word) { return word >> kGenerationShift; }
constexpr std::uint64_t kind_of(std::uint64_t word) { return (word >> kKindShift) & kKindMask; }
constexpr std::uint64_t make_word(std::uint64_t generation, std::uint64_t kind) {
  return generation << kGenerationShift | kind << kKindShift;
}

void* make_handle(std::uint64_t slot, std::uint64_t generation) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(generation << (kSlotBits + 1) | slot << 1 | 1));
}

std::uint64_t number_of(const void* handle) { return reinterpret_cast<std::uintptr_t>(handle); }
Slot& slot_of(const void* handle) { return slots[(number_of(handle) >> 1) % kSlots]; }
std::uint64_t generation_of(const void* handle) { return number_of(handle) >> (kSlotBits + 1); }

const void* this_thread() {
  static thread_local char token;
  return &token;
}

}  // namespace

Status Gate::enter() noexcept {
  const void* const me = this_thread();
  const void* owner = nullptr;
  if (owner_.compare_exchange_strong(owner, me, std::memory_order_acquire, std::memory_order_relaxed)) {
    return Status::kOk;
  }
  // Only this thread writes its own token, and takes it away before it leaves: reading it here means being inside.
  return owner == me ? Status::kReentrant : Status::kBusy;
}

void* publish(Object* object) noexcept {
  const std::uint64_t start = next_slot.load(std::memory_order_relaxed);
  for (std::uint64_t i = 0; i < kSlots; ++i) {
    const std::uint64_t index = (start + i) % kSlots;
    Slot& slot = slots[index];
    std::uint64_t word = slot.word.load(std::memory_order_relaxed);
    if (kind_of(word) != kFree || generation_of(word) == kLastGeneration) continue;
    const std::uint64_t generation = generation_of(word) + 1;
    if (!slot.word.compare_exchange_strong(word, make_word(generation, kReserved), std::memory_order_acquire)) continue;
    slot.object.store(object, std::memory_order_relaxed);
    slot.word.store(make_word(generation, static_cast<std::uint64_t>(object->kind())), std::memory_order_release);
    next_slot.store(index + 1, std::memory_order_relaxed);
    return make_handle(index, generation);
  }
  return nullptr;
}

Object* pin(const void* handle, ObjectKind kind) noexcept {
  if (number_of(handle) % 2 == 0 || generation_of(handle) > kLastGeneration) return nullptr;
  const std::uint64_t wanted = make_word(generation_of(handle), static_cast<std::uint64_t>(kind));
  Slot& slot = slot_of(handle);
  std::uint64_t word = slot.word.load(std::memory_order_relaxed);
  do {
    if ((word & ~kPinMask) != wanted) return nullptr;  // other generation, other kind or dying
    if ((word & kPinMask) == kPinMask) return nullptr;
  } while (!slot.word.compare_exchange_weak(word, word + 1, std::memory_order_acquire, std::memory_order_relaxed));
  return slot.object.load(std::memory_order_relaxed);
}

void unpin(const void* handle) noexcept { slot_of(handle).word.fetch_sub(1, std::memory_order_release); }

Object* withdraw(const void* handle) noexcept {
  Slot& slot = slot_of(handle);
  slot.word.fetch_or(kDying, std::memory_order_relaxed);
  // The other pins are calls about to find the gate closed, or a cancel storing its flag: a few instructions each.
  while ((slot.word.load(std::memory_order_acquire) & kPinMask) > 1) std::this_thread::yield();
  Object* const object = slot.object.exchange(nullptr, std::memory_order_relaxed);
  slot.word.store(make_word(generation_of(handle), kFree), std::memory_order_release);
  next_slot.store((number_of(handle) >> 1) % kSlots, std::memory_order_relaxed);
  return object;
}

}  // namespace vbgpd::capi
