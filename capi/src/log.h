// The log of a context: a ring of fixed lines, so that saying something takes no memory. Models and jobs share it and
// may run on several threads at once.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>

#include "base/log.h"

namespace vbgpd::capi {

struct LoggedLine {
  LogLevel level = LogLevel::kInfo;
  std::int64_t sequence = 0;
  double seconds = 0;  ///< since the context was created
  LogLine line;
};

class LogRing final : public Log {
 public:
  void add(LogLevel level, std::string_view text) noexcept override;
  /// The oldest line kept whose sequence is above `after`.
  std::optional<LoggedLine> next(std::int64_t after) const noexcept;

 private:
  static constexpr std::int64_t kKept = 256;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start_ = Clock::now();
  mutable std::mutex mutex_;
  std::array<LoggedLine, kKept> lines_;
  std::int64_t newest_ = 0;
};

}  // namespace vbgpd::capi
