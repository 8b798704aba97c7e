// Numbers and counts as text, for reports, messages and pictures.
#pragma once

#include <cstdint>
#include <string>

namespace cli {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// 12345 -> "12 345"
std::string with_thousands(std::int64_t n);

/// "1 trial", "2 trials"
std::string counted(std::int64_t n, const std::string& noun);

/// The shortest text of up to `digits` significant digits, never with an exponent: 0.5, 450000, 12.25.
std::string plain_number(double value, int digits = 6);

/// "850 ms", "6.1 s", "2 min 05 s", "1 h 12 min"
std::string duration(double seconds);

}  // namespace cli
