// The host's progress function, called in the host's floating-point environment; what it throws stops there.
#pragma once

#include "float_environment.h"
#include "vbgpd/vbgpd.h"

namespace vbgpd::capi {

class Listener {
 public:
  Listener(vbgpd_progress_fn fn, void* user, const std::fenv_t& callers) : fn_(fn), user_(user), callers_(callers) {}

  /// False: the host wants to stop, or threw.
  bool go_on(const vbgpd_progress& progress) noexcept {
    if (fn_ == nullptr) return true;
    const CallersFloatEnvironment environment(callers_);
    try {
      return fn_(user_, &progress) == 0;
    } catch (...) {
      threw_ = true;
      return false;
    }
  }
  bool present() const { return fn_ != nullptr; }
  bool threw() const { return threw_; }

 private:
  vbgpd_progress_fn fn_;
  void* user_;
  const std::fenv_t& callers_;
  bool threw_ = false;
};

}  // namespace vbgpd::capi
