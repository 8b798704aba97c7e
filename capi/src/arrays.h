// Strided arrays of the caller: byte strides in, packed rows inside.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "convert.h"

namespace vbgpd::capi {

/// Where component c of item i is: i*item + c*component bytes.
struct Strides {
  std::int64_t item, component;
};
/// 0 = packed rows. Every number must have bytes of its own when it is written to: rows lie apart and columns within
/// them, or the other way round. `argument` is the number of the item's stride.
Strides strides_in(std::int64_t item, std::int64_t component, std::int64_t components, std::int64_t count,
                   int argument);
/// One number per item; 0 = packed.
std::int64_t stride_in(std::int64_t stride, std::int64_t count, int argument);

void require_count(std::int64_t n, int argument, const char* what);
/// Sets *n and says whether `count` items are wanted and fit into `cap`. `argument` is the number of cap.
bool items_fit(std::int64_t count, std::int64_t cap, std::int64_t* n, int argument);

template <class Number>
void scatter(const std::vector<Number>& rows, int components, Strides strides, void* dst) {
  char* const at = static_cast<char*>(dst);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto item = static_cast<std::int64_t>(k) / components;
    const auto component = static_cast<std::int64_t>(k) % components;
    std::memcpy(at + item * strides.item + component * strides.component, &rows[k], sizeof(Number));
  }
}

template <class Number>
std::vector<Number> gather(const void* src, int components, Strides strides, std::int64_t count) {
  const char* const at = static_cast<const char*>(src);
  std::vector<Number> rows(static_cast<std::size_t>(count * components));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto item = static_cast<std::int64_t>(k) / components;
    const auto component = static_cast<std::int64_t>(k) % components;
    std::memcpy(&rows[k], at + item * strides.item + component * strides.component, sizeof(Number));
  }
  return rows;
}

/// (bytes, len) at argument and argument + 1.
std::span<const std::uint8_t> bytes_in(const void* bytes, std::int64_t len, int argument);
/// (buf, cap, needed) from `argument` on.
void bytes_out(std::span<const std::uint8_t> bytes, void* buf, std::int64_t cap, std::int64_t* needed, int argument);

}  // namespace vbgpd::capi
