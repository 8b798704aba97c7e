// What a job says to the log while it runs: phases, verdicts, grids and its end. Read off its results between two
// slices of work, so that no analysis has to think of it.
#pragma once

#include <cstddef>

#include "analysis/job.h"

namespace vbgpd {

class Teller {
 public:
  /// `log` may be null.
  void look(Log* log, const Progress& progress, const JobResult& result) noexcept;
  void end(Log* log, Status outcome, const JobResult& result) const noexcept;

 private:
  int level_ = -1, phase_ = 0;
  std::size_t trials_ = 0, levels_ = 0;
};

}  // namespace vbgpd
