#include "log.h"

#include <algorithm>

#include "convert.h"
#include "guard.h"

namespace vbgpd::capi {

void LogRing::add(LogLevel level, std::string_view text) noexcept {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const std::lock_guard<std::mutex> lock(mutex_);
  LoggedLine& to = lines_[static_cast<std::size_t>(++newest_ % kKept)];
  to.level = level, to.sequence = newest_, to.seconds = seconds;
  to.line = {};
  to.line << text;
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
    vbgpd_log_line told{};
    told.struct_size = sizeof told;
    told.level = static_cast<std::int32_t>(found->level);
    told.sequence = found->sequence;
    told.seconds = found->seconds;
    fill(line, told);
    if (wanted) text_copy(found->line.text(), text);
    return Status::kOk;
  });
}
