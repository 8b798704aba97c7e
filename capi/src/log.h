// The log of a context: a ring of fixed lines, so that saying something takes no memory. Models and jobs share it and
// may run on several threads at once.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>

#include "base/error.h"
#include "base/log.h"
#include "vbgpd/vbgpd.h"

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
  /// Lines of that level and below go to fn as well, nullptr = to nobody. kBusy, kReentrant: fn is being called.
  Status tell_to(vbgpd_log_fn fn, void* user, LogLevel level) noexcept;
  /// Tells nobody any more, once a call of fn on another thread has returned.
  void fall_silent() noexcept;

 private:
  void tell(const LoggedLine& line) noexcept;
  bool telling_here() const noexcept { return teller_.load() == std::this_thread::get_id(); }

  static constexpr std::int64_t kKept = 256;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start_ = Clock::now();
  mutable std::mutex mutex_;
  std::array<LoggedLine, kKept> lines_;
  std::int64_t newest_ = 0;
  std::mutex telling_;  ///< held while fn_ is called or changed
  std::atomic<std::thread::id> teller_{};
  vbgpd_log_fn fn_ = nullptr;
  void* user_ = nullptr;
  LogLevel level_ = LogLevel::kDetail;
};

/// The line as the C face shows it.
vbgpd_log_line shown(const LoggedLine& line);

}  // namespace vbgpd::capi
