#include "log.h"

#include <algorithm>

#include "convert.h"
#include "guard.h"

namespace vbgpd::capi {

void LogRing::add(LogLevel level, std::string_view text) noexcept {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  LoggedLine said;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    LoggedLine& to = lines_[static_cast<std::size_t>(++newest_ % kKept)];
    to.level = level, to.sequence = newest_, to.seconds = seconds;
    to.line = {};
    to.line << text;
    said = to;
  }
  if (!telling_here()) tell(said);
}

void LogRing::tell(const LoggedLine& said) noexcept {
  const std::lock_guard<std::mutex> lock(telling_);
  if (fn_ == nullptr || said.level > level_) return;
  const vbgpd_log_line line = shown(said);
  char text[LogLine::kMost + 1] = {};
  const std::string_view words = said.line.text();
  words.copy(text, LogLine::kMost);
  teller_ = std::this_thread::get_id();
  try {
    fn_(user_, &line, text);
  } catch (...) {  // nobody could be told
  }
  teller_ = std::thread::id();
}

Status LogRing::tell_to(vbgpd_log_fn fn, void* user, LogLevel level) noexcept {
  if (telling_here()) return Status::kReentrant;
  const std::unique_lock<std::mutex> lock(telling_, std::try_to_lock);
  if (!lock) return Status::kBusy;
  fn_ = fn, user_ = user, level_ = level;
  return Status::kOk;
}

void LogRing::fall_silent() noexcept {
  if (telling_here()) {
    fn_ = nullptr;
    return;
  }
  const std::lock_guard<std::mutex> lock(telling_);
  fn_ = nullptr;
}

vbgpd_log_line shown(const LoggedLine& line) {
  vbgpd_log_line told{};
  told.struct_size = sizeof told;
  told.level = static_cast<std::int32_t>(line.level);
  told.sequence = line.sequence;
  told.seconds = line.seconds;
  return told;
}

std::optional<LoggedLine> LogRing::next(std::int64_t after) const noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::int64_t oldest = std::max<std::int64_t>(1, newest_ - kKept + 1);
  if (after >= newest_) return std::nullopt;
  return lines_[static_cast<std::size_t>(std::max(oldest, after + 1) % kKept)];
}

}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_context_log_next(vbgpd_context* context, int64_t after, vbgpd_log_line* line, char* text,
                                    int64_t cap, int64_t* needed) {
  return with(context, [&](ContextObject& object) {
    require_struct(line, 3, true);
    const std::optional<LoggedLine> found = object.log->next(after);
    if (!found) return Status::kEndOfData;
    const bool wanted = text_fits(found->line.text(), text, text == nullptr ? 0 : cap, needed, 4);
    fill(line, shown(*found));
    if (wanted) text_copy(found->line.text(), text);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_context_set_log(vbgpd_context* context, vbgpd_log_fn fn, void* user, int32_t level) {
  return with(context, [&](ContextObject& object) {
    if (fn == nullptr) level = VBGPD_LOG_WARNING;  // to end it takes no level
    if (level < VBGPD_LOG_WARNING || level > VBGPD_LOG_DETAIL)
      throw ArgumentError(4, Status::kRange,
                          "level is " + std::to_string(level) + "; it must be one of VBGPD_LOG_* (1 to 3).");
    const Status status = object.log->tell_to(fn, user, static_cast<LogLevel>(level));
    if (status == Status::kOk) return status;
    throw Error(status, "The log function is being called: it can be changed once it has returned.");
  });
}
