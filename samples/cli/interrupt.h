// Ctrl-C asks the running job to stop at its next step; a second Ctrl-C ends the program at once.
#pragma once

#include "engine.h"

namespace cli {

/// While it lives, an interrupt (SIGINT) cancels the job it was told of.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  void watch(vbgpd_job* job);
  static bool requested();
};

}  // namespace cli
