// Between C arguments and the engine's types: text, structs with struct_size, strided arrays. No physics.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "error_record.h"
#include "scene/scene_def.h"
#include "vbgpd/vbgpd.h"

namespace vbgpd::capi {

void require_not_null(const void* pointer, int argument, const char* name);

/// R7: (pointer, length), length -1 = NUL-terminated; checks that it is UTF-8 without NUL. NULL only with length 0.
std::string_view text_in(const char* text, std::int64_t length, int argument, const char* name);

/// Checks the buffer of R7 and sets *needed; true = the text is wanted and fits. `argument` is the number of buf.
bool text_fits(std::string_view text, const char* buf, std::int64_t cap, std::int64_t* needed, int argument);
void text_copy(std::string_view text, char* buf);
/// text_fits and text_copy in one.
void text_out(std::string_view text, char* buf, std::int64_t cap, std::int64_t* needed, int argument);

/// R9: a struct holds at least its size and one field.
inline constexpr std::uint32_t kSmallestStruct = 8;
void require_struct_size(std::uint32_t struct_size, int argument);

/// A struct the caller wants filled; NULL only when it may be.
template <class Struct>
void require_struct(const Struct* to, int argument, bool may_be_null = false) {
  if (to == nullptr && may_be_null) return;
  require_not_null(to, argument, "struct");
  require_struct_size(to->struct_size, argument);
}

/// Fills a checked struct as far as it goes and keeps its struct_size; does nothing for NULL.
template <class Struct>
void fill(Struct* to, const Struct& from) {
  if (to == nullptr) return;
  constexpr std::size_t head = sizeof(to->struct_size);
  const std::size_t size = std::min<std::size_t>(to->struct_size, sizeof(Struct));
  std::memcpy(reinterpret_cast<char*>(to) + head, reinterpret_cast<const char*>(&from) + head, size - head);
}

/// n points at xy + i*stride bytes. `argument` is the number of xy; stride and n follow it.
Polygon points_in(const double* xy, std::int64_t stride, std::int64_t n, int argument);
/// Sets *n and copies all points unless cap is 0. `argument` is the number of xy; stride, cap, n follow it.
void points_out(const std::vector<Point>& points, double* xy, std::int64_t stride, std::int64_t cap, std::int64_t* n,
                int argument);

vbgpd_error_info info_of(const Issue& issue, int argument);

/// Fills an issue or error record for the caller: info and text may be NULL. Arguments 2 to 5 or, behind an index, 3
/// to 6.
void issue_out(const Issue& issue, int fault_argument, vbgpd_error_info* info, char* text, std::int64_t cap,
               std::int64_t* needed, int argument);

/// Item i of a list; nullptr past the last.
template <class List>
const typename List::value_type* item_at(const List& list, std::int64_t i, int argument) {
  if (i < 0) {
    throw ArgumentError(argument, Status::kArgument, "The index is " + std::to_string(i) + "; it must be 0 or more.");
  }
  return static_cast<std::uint64_t>(i) < list.size() ? &list[static_cast<std::size_t>(i)] : nullptr;
}

}  // namespace vbgpd::capi
