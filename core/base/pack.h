// A pack: as many doubles as one vector register holds, worked on in lockstep. The same law code runs on double and on
// Pack.
//
// The files of step/ that use packs are compiled once per instruction set (see step/CMakeLists.txt), each time in
// another inline namespace, so that no function built for a newer processor can be linked into the portable path.
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#ifndef VBGPD_ISA
#define VBGPD_ISA portable
#endif

namespace vbgpd {

inline namespace VBGPD_ISA {

/// Lanes of a pack. Where the registers are narrower the compiler splits a pack over several of them.
#if defined(VBGPD_WIDTH)
inline constexpr int kWidth = VBGPD_WIDTH;
#else
inline constexpr int kWidth = 4;
#endif

using Pack [[gnu::vector_size(kWidth * sizeof(double))]] = double;
using PackU [[gnu::vector_size(kWidth * sizeof(double)), gnu::aligned(8), gnu::may_alias]] = double;
using SinglePackU [[gnu::vector_size(kWidth * sizeof(float)), gnu::aligned(4), gnu::may_alias]] = float;
using Mask [[gnu::vector_size(kWidth * sizeof(double))]] = std::int64_t;

/// What a comparison of two R gives: bool, or a mask of the lanes.
template <class R>
using Truth = decltype(R{} > R{});

#define VBGPD_INLINE [[gnu::always_inline]] inline

VBGPD_INLINE Pack load(const double* p) { return *reinterpret_cast<const PackU*>(p); }
VBGPD_INLINE Pack load(const float* p) {
  return __builtin_convertvector(*reinterpret_cast<const SinglePackU*>(p), Pack);
}
VBGPD_INLINE void store(double* p, Pack v) { *reinterpret_cast<PackU*>(p) = v; }
/// v in every lane (v - 0 is v, also for -0, so nothing is computed).
template <class R>
VBGPD_INLINE R filled(double v) {
  return v - R{};
}
VBGPD_INLINE Pack broadcast(double v) { return filled<Pack>(v); }

VBGPD_INLINE Pack select(Mask m, Pack a, Pack b) { return m ? a : b; }
VBGPD_INLINE double select(bool m, double a, double b) { return m ? a : b; }

VBGPD_INLINE bool any(bool m) { return m; }
VBGPD_INLINE bool any(Mask m) {
#if defined(__AVX512F__) && VBGPD_WIDTH == 8
  return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(m), reinterpret_cast<__m512i>(m)) != 0;
#elif defined(__AVX__) && VBGPD_WIDTH == 4
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(m)) != 0;
#else
  bool r = false;
  for (int l = 0; l < kWidth; ++l) r |= m[l] != 0;
  return r;
#endif
}

VBGPD_INLINE double root(double v) { return __builtin_sqrt(v); }
VBGPD_INLINE Pack root(Pack v) {
#if defined(__AVX512F__) && VBGPD_WIDTH == 8
  return reinterpret_cast<Pack>(_mm512_maskz_sqrt_pd(0xff, reinterpret_cast<__m512d>(v)));
#elif defined(__AVX__) && VBGPD_WIDTH == 4
  return reinterpret_cast<Pack>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(v)));
#else
  Pack r;
  for (int l = 0; l < kWidth; ++l) r[l] = __builtin_sqrt(v[l]);
  return r;
#endif
}

VBGPD_INLINE double larger(double a, double b) { return a > b ? a : b; }
VBGPD_INLINE double smaller(double a, double b) { return a < b ? a : b; }
VBGPD_INLINE Pack larger(Pack a, Pack b) { return a > b ? a : b; }
VBGPD_INLINE Pack smaller(Pack a, Pack b) { return a < b ? a : b; }
VBGPD_INLINE Pack magnitude(Pack a) { return larger(a, -a); }
VBGPD_INLINE double magnitude(double a) { return __builtin_fabs(a); }

/// Sum and maximum over the lanes, always in the same order.
VBGPD_INLINE double lane_sum(Pack v) {
  double s = 0;
  for (int l = 0; l < kWidth; ++l) s += v[l];
  return s;
}
VBGPD_INLINE double lane_max(Pack v) {
  double s = v[0];
  for (int l = 1; l < kWidth; ++l) s = v[l] > s ? v[l] : s;
  return s;
}

}  // namespace VBGPD_ISA
}  // namespace vbgpd
