#include "convert.h"

namespace vbgpd::capi {
namespace {

[[noreturn]] void refuse(int argument, const std::string& text) {
  throw ArgumentError(argument, Status::kArgument, text);
}

// Length of the UTF-8 sequence that starts a text, 0 = none (Unicode 15, table 3-7: no overlong forms, no surrogates).
std::size_t utf8_sequence(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
  const unsigned char low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
  const unsigned char high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  }
  return length;
}

void require_utf8(std::string_view text, int argument, const char* name) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = text[i] == '\0' ? 0 : utf8_sequence(text.substr(i));
    if (length == 0) {
      refuse(argument, std::string("The text \"") + name + "\" is not UTF-8 without NUL: byte " + std::to_string(i) +
                           " has the value " + std::to_string(static_cast<unsigned char>(text[i])) + ".");
    }
    i += length;
  }
}

constexpr std::int64_t kPair = 2 * sizeof(double);

void require_stride(std::int64_t stride, int argument) {
  if (stride >= kPair || stride <= -kPair) return;
  refuse(argument, "The stride is " + std::to_string(stride) +
                       " bytes; points of two doubles need 16 (packed pairs) or more, or -16 or less.");
}

}  // namespace

void require_not_null(const void* pointer, int argument, const char* name) {
  if (pointer == nullptr) refuse(argument, std::string("The pointer \"") + name + "\" is NULL.");
}

std::string_view text_in(const char* text, std::int64_t length, int argument, const char* name) {
  if (length < VBGPD_STRLEN) {
    refuse(argument + 1, std::string("The length of the text \"") + name + "\" is " + std::to_string(length) +
                             "; it must be 0 or more, or -1 for a text that ends at its NUL.");
  }
  if (length == 0) return {};
  require_not_null(text, argument, name);
  const std::string_view view =
      length < 0 ? std::string_view(text) : std::string_view(text, static_cast<std::size_t>(length));
  require_utf8(view, argument, name);
  return view;
}

bool text_fits(std::string_view text, const char* buf, std::int64_t cap, std::int64_t* needed, int argument) {
  if (cap < 0)
    refuse(argument + 1, "The capacity of the text buffer is " + std::to_string(cap) + "; it must be 0 or more.");
  if (cap > 0) require_not_null(buf, argument, "buf");
  const auto size = static_cast<std::int64_t>(text.size());
  if (needed != nullptr) *needed = size;
  if (cap == 0) return false;
  if (cap <= size) {
    throw ArgumentError(argument + 1, Status::kBuffer,
                        "The text buffer holds " + std::to_string(cap) + " bytes; the text and its NUL need " +
                            std::to_string(size + 1) + ".");
  }
  return true;
}

void text_copy(std::string_view text, char* buf) {
  text.copy(buf, text.size());
  buf[text.size()] = '\0';
}

void text_out(std::string_view text, char* buf, std::int64_t cap, std::int64_t* needed, int argument) {
  if (text_fits(text, buf, cap, needed, argument)) text_copy(text, buf);
}

void require_struct_size(std::uint32_t struct_size, int argument) {
  if (struct_size >= kSmallestStruct) return;
  refuse(argument, "struct_size is " + std::to_string(struct_size) +
                       "; set it to sizeof the struct before the call (or use the matching _init function).");
}

Polygon points_in(const double* xy, std::int64_t stride, std::int64_t n, int argument) {
  if (n < 0) refuse(argument + 2, "The number of points is " + std::to_string(n) + "; it must be 0 or more.");
  Polygon points;
  if (n == 0) return points;
  require_not_null(xy, argument, "xy");
  require_stride(stride, argument + 1);
  points.reserve(static_cast<std::size_t>(n));
  const char* at = reinterpret_cast<const char*>(xy);
  for (std::int64_t i = 0; i < n; ++i) {
    // memcpy: a stride need not be a multiple of the alignment of a double.
    const char* const from = at + i * stride;
    Point point;
    std::memcpy(&point.x, from, sizeof point.x);
    std::memcpy(&point.y, from + sizeof point.x, sizeof point.y);
    points.push_back(point);
  }
  return points;
}

void points_out(const std::vector<Point>& points, double* xy, std::int64_t stride, std::int64_t cap, std::int64_t* n,
                int argument) {
  if (cap < 0) refuse(argument + 2, "The capacity is " + std::to_string(cap) + " points; it must be 0 or more.");
  const auto count = static_cast<std::int64_t>(points.size());
  if (n != nullptr) *n = count;
  if (cap == 0) return;
  require_not_null(xy, argument, "xy");
  require_stride(stride, argument + 1);
  if (cap < count) {
    throw ArgumentError(
        argument + 2, Status::kBuffer,
        "The array holds " + std::to_string(cap) + " points; " + std::to_string(count) + " are needed.");
  }
  char* const at = reinterpret_cast<char*>(xy);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point& point = points[static_cast<std::size_t>(i)];
    std::memcpy(at + i * stride, &point.x, sizeof point.x);
    std::memcpy(at + i * stride + sizeof point.x, &point.y, sizeof point.y);
  }
}

vbgpd_error_info info_of(const Issue& issue, int argument) {
  vbgpd_error_info info{};
  info.struct_size = sizeof info;
  info.status = issue.severity == Severity::kWarning ? VBGPD_OK : static_cast<std::int32_t>(issue.status);
  info.object_kind = static_cast<std::int32_t>(issue.object);
  info.argument = argument;
  info.object_id = issue.object_id;
  info.item = issue.item;
  info.x = issue.x;
  info.y = issue.y;
  info.value = issue.value;
  return info;
}

void issue_out(const Issue& issue, int fault_argument, vbgpd_error_info* info, char* text, std::int64_t cap,
               std::int64_t* needed, int argument) {
  require_struct(info, argument, true);
  const bool wanted = text_fits(issue.text, text, text == nullptr ? 0 : cap, needed, argument + 1);
  fill(info, info_of(issue, fault_argument));
  if (wanted) text_copy(issue.text, text);
}

}  // namespace vbgpd::capi
