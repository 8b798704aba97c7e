// The last failure of a call on an object, kept on the object (not on the thread) until the next one.
#pragma once

#include <string>

#include "base/error.h"

namespace vbgpd::capi {

/// An Error that knows which argument of the C function was at fault.
class ArgumentError : public Error {
 public:
  ArgumentError(int argument, Status status, const std::string& text) : Error(status, text), argument_(argument) {}
  ArgumentError(int argument, const Issue& issue) : Error(issue), argument_(argument) {}
  int argument() const { return argument_; }

 private:
  int argument_;  // 1-based
};

struct ErrorRecord {
  Issue issue{.status = Status::kOk, .text = {}};  ///< status kOk = no failure so far
  int argument = 0;                                ///< 1-based, 0 = none

  bool empty() const { return issue.status == Status::kOk; }
  /// Takes what the exception now being handled says and returns its status; survives running out of memory.
  Status keep_current_exception() noexcept;
};

}  // namespace vbgpd::capi
