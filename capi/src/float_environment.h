// R2: the engine computes in the default floating-point environment (rounding to nearest, no traps, no flush to zero)
// and hands the caller's back, exception flags included.
#pragma once

#include <cfenv>

namespace vbgpd::capi {

class DefaultFloatEnvironment {
 public:
  DefaultFloatEnvironment() noexcept {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloatEnvironment() { std::fesetenv(&callers_); }
  DefaultFloatEnvironment(const DefaultFloatEnvironment&) = delete;
  DefaultFloatEnvironment& operator=(const DefaultFloatEnvironment&) = delete;

 private:
  std::fenv_t callers_;
};

/// The caller's environment again while a callback of the caller runs.
class CallersFloatEnvironment {
 public:
  explicit CallersFloatEnvironment(const std::fenv_t& callers) noexcept {
    std::fegetenv(&ours_);
    std::fesetenv(&callers);
  }
  ~CallersFloatEnvironment() { std::fesetenv(&ours_); }
  CallersFloatEnvironment(const CallersFloatEnvironment&) = delete;
  CallersFloatEnvironment& operator=(const CallersFloatEnvironment&) = delete;

 private:
  std::fenv_t ours_;
};

}  // namespace vbgpd::capi
