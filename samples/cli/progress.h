// One line on the terminal, rewritten in place while a job runs.
#pragma once

#include <chrono>
#include <string>

#include "engine.h"

namespace cli {

/// "grid 2/2  trial 4  F=1.352  bracket [1.301,1.352]  R=3.2e-05  58 %  6.1 s left"
std::string progress_text(const vbgpd_progress& progress, int levels, double elapsed_seconds);

class ProgressLine {
 public:
  /// Shows nothing unless stderr is a terminal.
  ProgressLine(bool wanted, int levels);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const vbgpd_progress& progress);
  void clear();

 private:
  bool enabled_, shown_ = false;
  int levels_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace cli
