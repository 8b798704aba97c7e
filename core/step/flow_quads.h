// Records of four doubles: four neighbours are loaded by four vector loads and turned, not by sixteen single ones.
#pragma once

#include <cstdint>

#include "base/pack.h"

namespace vbgpd {
inline namespace VBGPD_ISA {

static_assert(kWidth == 4, "a pack of the run-out step is four neighbours");

struct Quads {
  Pack a, b, c, d;  ///< first to fourth member of four records
};

VBGPD_INLINE Quads turned(Pack r0, Pack r1, Pack r2, Pack r3) {
  const Pack t0 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6), t1 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Pack t2 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6), t3 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  return {__builtin_shufflevector(t0, t2, 0, 1, 4, 5), __builtin_shufflevector(t1, t3, 0, 1, 4, 5),
          __builtin_shufflevector(t0, t2, 2, 3, 6, 7), __builtin_shufflevector(t1, t3, 2, 3, 6, 7)};
}

VBGPD_INLINE Quads load_quads(const double* records, const std::int32_t* j) {
  return turned(load(records + 4l * j[0]), load(records + 4l * j[1]), load(records + 4l * j[2]),
                load(records + 4l * j[3]));
}
VBGPD_INLINE Quads broadcast_quad(const double* record) {
  return {broadcast(record[0]), broadcast(record[1]), broadcast(record[2]), broadcast(record[3])};
}
VBGPD_INLINE Pack load_each(const double* values, const std::int32_t* j) {
  return Pack{values[j[0]], values[j[1]], values[j[2]], values[j[3]]};
}

/// First two members of four records.
struct FirstTwo {
  Pack a, b;
};
VBGPD_INLINE FirstTwo load_first_two(const double* records, const std::int32_t* j) {
  using Pair [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;
  const auto pair = [&](int k) { return *reinterpret_cast<const Pair*>(records + 4l * j[k]); };
  const Pack r0 = __builtin_shufflevector(pair(0), pair(2), 0, 1, 2, 3);
  const Pack r1 = __builtin_shufflevector(pair(1), pair(3), 0, 1, 2, 3);
  return {__builtin_shufflevector(r0, r1, 0, 4, 2, 6), __builtin_shufflevector(r0, r1, 1, 5, 3, 7)};
}

/// Sums over the lanes of four packs at once.
VBGPD_INLINE Pack sums_of(Pack a, Pack b, Pack c, Pack d) {
  const Quads t = turned(a, b, c, d);
  return (t.a + t.b) + (t.c + t.d);
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
