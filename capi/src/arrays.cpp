#include "arrays.h"

#include <cstdlib>

namespace vbgpd::capi {

Strides strides_in(std::int64_t item, std::int64_t component, std::int64_t components, std::int64_t count,
                   int argument) {
  constexpr std::int64_t kNumber = 8;
  if (component == 0) component = kNumber;
  if (item == 0) item = kNumber * components;
  const std::int64_t step = components > 1 ? std::abs(component) : kNumber;
  const std::int64_t row = count > 1 ? std::abs(item) : kNumber * components;
  const bool apart = step >= kNumber && row >= kNumber &&
                     (components == 1 || count == 1 || (row - kNumber) / step >= components - 1 ||
                      (step - kNumber) / row >= count - 1);
  if (apart) return {item, component};
  throw ArgumentError(argument, Status::kArgument,
                      "The strides " + std::to_string(item) + " (item) and " + std::to_string(component) +
                          " (component) bytes make numbers of 8 bytes overlap.");
}

std::int64_t stride_in(std::int64_t stride, std::int64_t count, int argument) {
  return strides_in(stride, 0, 1, count, argument).item;
}

void require_count(std::int64_t n, int argument, const char* what) {
  if (n >= 0) return;
  throw ArgumentError(argument, Status::kArgument,
                      std::string("The number of ") + what + " is " + std::to_string(n) + "; it must be 0 or more.");
}

bool items_fit(std::int64_t count, std::int64_t cap, std::int64_t* n, int argument) {
  if (cap < 0) {
    throw ArgumentError(argument, Status::kArgument,
                        "The capacity is " + std::to_string(cap) + " items; it must be 0 or more.");
  }
  if (n != nullptr) *n = count;
  if (cap == 0) return false;
  if (cap < count) {
    throw ArgumentError(argument, Status::kBuffer,
                        "The array holds " + std::to_string(cap) + " items; " + std::to_string(count) + " are needed.");
  }
  return true;
}

std::span<const std::uint8_t> bytes_in(const void* bytes, std::int64_t len, int argument) {
  if (len < 0) {
    throw ArgumentError(argument + 1, Status::kArgument,
                        "len is " + std::to_string(len) + "; it must be the number of bytes.");
  }
  require_not_null(bytes, argument, "bytes");
  return {static_cast<const std::uint8_t*>(bytes), static_cast<std::size_t>(len)};
}

void bytes_out(std::span<const std::uint8_t> bytes, void* buf, std::int64_t cap, std::int64_t* needed, int argument) {
  if (cap < 0)
    throw ArgumentError(argument + 1, Status::kArgument,
                        "The capacity is " + std::to_string(cap) + " bytes; it must be 0 or more.");
  const auto size = static_cast<std::int64_t>(bytes.size());
  if (needed != nullptr) *needed = size;
  if (cap == 0) return;
  require_not_null(buf, argument, "buf");
  if (cap < size)
    throw ArgumentError(argument + 1, Status::kBuffer,
                        "The buffer holds " + std::to_string(cap) + " bytes; " + std::to_string(size) + " are needed.");
  std::memcpy(buf, bytes.data(), bytes.size());
}

}  // namespace vbgpd::capi
