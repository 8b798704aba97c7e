// What the engine has to say to its host: a few lines, never printed. A host that wants them hands in a Log.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace vbgpd {

/// Same numbers as VBGPD_LOG_* in vbgpd.h.
enum class LogLevel : std::int32_t { kWarning = 1, kInfo = 2, kDetail = 3 };

class Log {
 public:
  virtual ~Log() = default;
  /// Called on the thread that is inside the call, never on a worker. `text` is a whole sentence in UTF-8.
  virtual void add(LogLevel level, std::string_view text) noexcept = 0;
};

/// A line put together in place: saying something takes no memory and cannot fail. What is too long is cut.
class LogLine {
 public:
  static constexpr std::size_t kMost = 247;  ///< bytes

  LogLine& operator<<(std::string_view text) noexcept {
    std::size_t n = text.size();
    if (n > kMost - size_) {
      n = kMost - size_;
      while (n > 0 && (text[n] & 0xc0) == 0x80) --n;  // not within a character
    }
    std::memcpy(text_ + size_, text.data(), n);
    size_ += n;
    return *this;
  }
  LogLine& operator<<(const char* text) noexcept { return *this << std::string_view(text); }
  LogLine& operator<<(std::integral auto value) noexcept {
    char digits[24];
    return *this << std::string_view(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  }
  LogLine& operator<<(double value) noexcept {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 4).ptr;
    return *this << std::string_view(digits, end);
  }
  std::string_view text() const noexcept { return {text_, size_}; }

 private:
  char text_[kMost];
  std::size_t size_ = 0;
};

}  // namespace vbgpd
