// The one guard around every function of the C face: handle check, one thread at a time, floating-point environment,
// nothing thrown. Bodies return kOk or a positive outcome and throw Error for everything else.
#pragma once

#include <memory>
#include <string>
#include <type_traits>

#include "float_environment.h"
#include "objects.h"

namespace vbgpd::capi {

inline vbgpd_status code(Status status) { return static_cast<vbgpd_status>(status); }

/// A body that belongs to no object; its failure is told by the status alone.
template <class Body>
vbgpd_status guarded(ErrorRecord& record, const Body& body) noexcept {
  const DefaultFloatEnvironment environment;
  try {
    return code(body());
  } catch (...) {
    return code(record.keep_current_exception());
  }
}

template <class Body>
vbgpd_status guarded(const Body& body) noexcept {
  ErrorRecord nowhere;
  return guarded(nowhere, body);
}

/// A handle looked up and kept alive for the length of a scope.
template <class Handle>
class Pinned {
 public:
  using Type = typename ObjectOf<std::remove_const_t<Handle>>::Type;
  explicit Pinned(Handle* handle) noexcept : handle_(handle), object_(static_cast<Type*>(pin(handle, Type::kKind))) {}
  ~Pinned() {
    if (object_) unpin(handle_);
  }
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;
  explicit operator bool() const { return object_ != nullptr; }
  Type& operator*() const { return *object_; }
  Type* operator->() const { return object_; }
  /// Ends the handle; the object is the caller's.
  std::unique_ptr<Object> withdraw_object() noexcept {
    object_ = nullptr;
    return std::unique_ptr<Object>(withdraw(handle_));
  }

 private:
  Handle* handle_;
  Type* object_;
};

/// Being inside a gate for the length of a scope.
class Inside {
 public:
  explicit Inside(Gate& gate) noexcept : gate_(gate), status_(gate.enter()) {}
  ~Inside() {
    if (status_ == Status::kOk) gate_.leave();
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  Status status() const { return status_; }

 private:
  Gate& gate_;
  Status status_;
};

/// Runs body(object) for a handle; a failure is kept on the object. Wrong handles, BUSY and REENTRANT leave no record:
/// the record belongs to whoever is inside.
template <class Handle, class Body>
vbgpd_status with(Handle* handle, const Body& body) noexcept {
  const Pinned<Handle> object(handle);
  if (!object) return VBGPD_E_HANDLE;
  const Inside inside(object->gate());
  if (inside.status() != Status::kOk) return code(inside.status());
  return guarded(object->error, [&] { return body(*object); });
}

/// Reads without leaving a record, for the functions that report records themselves.
template <class Handle, class Body>
vbgpd_status peek(Handle* handle, const Body& body) noexcept {
  const Pinned<Handle> object(handle);
  if (!object) return VBGPD_E_HANDLE;
  const Inside inside(object->gate());
  if (inside.status() != Status::kOk) return code(inside.status());
  return guarded([&] { return body(*object); });
}

/// Enters a gate from within a body.
inline void require(const Inside& inside, int argument, const char* what) {
  if (inside.status() == Status::kOk) return;
  throw ArgumentError(argument, inside.status(), std::string("The ") + what + " is in use by another call.");
}

template <class Handle>
vbgpd_status destroy(Handle* handle) noexcept {
  if (handle == nullptr) return VBGPD_OK;
  const DefaultFloatEnvironment environment;
  Pinned<Handle> object(handle);
  if (!object) return VBGPD_E_HANDLE;
  Gate& gate = object->gate();
  if (const Status status = gate.enter(); status != Status::kOk) return code(status);
  if constexpr (std::is_same_v<Handle, vbgpd_model>) object->engine->leases.clear();  // its jobs go on
  const std::unique_ptr<Object> owned = object.withdraw_object();
  gate.leave();  // a model's gate lives on in its jobs
  return VBGPD_OK;
}

/// Hands a new object to the caller.
template <class Handle>
void hand_out(std::unique_ptr<typename ObjectOf<Handle>::Type> object, Handle** out) {
  void* const handle = publish(object.get());
  if (handle == nullptr) throw Error(Status::kLimit, "There are 65536 objects alive; destroy some of them first.");
  object.release();
  *out = static_cast<Handle*>(handle);
}

}  // namespace vbgpd::capi
