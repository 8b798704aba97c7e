// Handles: which ones are alive, and who is inside them. The table behind it is the only global of the library.
//
// A handle is not an address. It is an odd number made of a slot of the table and the generation of that slot, so that
// no handle is ever dereferenced before it was looked up, a destroyed one never becomes valid again and no aligned
// pointer of the host can be taken for one. It uses 47 bits: runtimes that box pointers into doubles can carry it.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/error.h"
#include "error_record.h"
#include "vbgpd/vbgpd.h"

namespace vbgpd::capi {

/// Lets one thread in at a time (R4) and knows the one inside (R5). Never waits.
class Gate {
 public:
  /// kOk, kBusy when another thread is inside, kReentrant when this thread is.
  Status enter() noexcept;
  void leave() noexcept { owner_.store(nullptr, std::memory_order_release); }

 private:
  std::atomic<const void*> owner_{nullptr};
};

/// What stands behind a handle.
class Object {
 public:
  explicit Object(ObjectKind kind) : kind_(kind) {}
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  virtual ~Object() = default;

  ObjectKind kind() const { return kind_; }
  virtual Gate& gate() noexcept { return gate_; }
  ErrorRecord error;  ///< guarded by gate()

 private:
  const ObjectKind kind_;
  Gate gate_;
};

/// A new handle for `object`, which now belongs to the table; nullptr when all slots are taken. Never throws, never
/// locks.
void* publish(Object* object) noexcept;
/// The object of a live handle of that kind, or nullptr. It stays alive until unpin(). Lock-free, safe in a signal
/// handler.
Object* pin(const void* handle, ObjectKind kind) noexcept;
void unpin(const void* handle) noexcept;
/// Ends the life of a pinned handle and gives its object back once nobody else has it pinned. The caller is inside its
/// gate.
Object* withdraw(const void* handle) noexcept;

}  // namespace vbgpd::capi
