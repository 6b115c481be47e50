#pragma once
/// Four doubles in one register, and the turn from four rows to four columns and back. For particles/ and coupling/ alone.
/// GCC and Clang vector types: the code is the same with AVX, without it, and on other processors.

#include <cmath>
#include <cstddef>
#include <cstdint>
#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "particles/store.h"

namespace similitude::pack {

using V4 = double __attribute__((vector_size(32)));
using Mask4 = decltype(V4{} < V4{});
using StoredV4 = double __attribute__((vector_size(32), may_alias));

inline V4 load(const Row& row) { return *reinterpret_cast<const StoredV4*>(&row); }
inline void store(Row& row, V4 value) { *reinterpret_cast<StoredV4*>(&row) = value; }
/// `column` is 32-byte aligned.
inline V4 load(const double* column) { return *reinterpret_cast<const StoredV4*>(column); }
inline void store(double* column, V4 value) { *reinterpret_cast<StoredV4*>(column) = value; }
inline V4 all(double value) { return V4{value, value, value, value}; }

inline V4 square_root(V4 a) {
#if defined(__AVX__)
  return _mm256_sqrt_pd(a);
#else
  return V4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}
inline V4 floor(V4 a) {
#if defined(__AVX__)
  return _mm256_floor_pd(a);
#else
  return V4{std::floor(a[0]), std::floor(a[1]), std::floor(a[2]), std::floor(a[3])};
#endif
}
inline V4 smaller(V4 a, V4 b) { return a < b ? a : b; }
inline V4 larger(V4 a, V4 b) { return a > b ? a : b; }

/// Bit l is set where lane l holds.
inline unsigned bits(Mask4 mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#else
  unsigned out = 0;
  for (unsigned lane = 0; lane < 4; ++lane) out |= (mask[lane] != 0 ? 1u : 0u) << lane;
  return out;
#endif
}

using F8 = float __attribute__((vector_size(32)));
using StoredF8 = float __attribute__((vector_size(32), may_alias));
using F4 = float __attribute__((vector_size(16)));

/// Bit l is set where column[l] <= limit; `column` is 32-byte aligned.
inline unsigned at_most(const float* column, float limit) {
  const F8 values = *reinterpret_cast<const StoredF8*>(column);
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(values, _mm256_set1_ps(limit), _CMP_LE_OQ)));
#else
  unsigned out = 0;
  for (unsigned lane = 0; lane < 8; ++lane) out |= (values[lane] <= limit ? 1u : 0u) << lane;
  return out;
#endif
}

/// Bit l is set where column[l] < 0; `column` is 32-byte aligned and holds no negative zero.
inline unsigned negative(const float* column) {
  const F8 values = *reinterpret_cast<const StoredF8*>(column);
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(values));
#else
  unsigned out = 0;
  for (unsigned lane = 0; lane < 8; ++lane) out |= (values[lane] < 0 ? 1u : 0u) << lane;
  return out;
#endif
}

/// Writes `first` + l for every bit l of eight, in order; returns how many. Eight numbers may be written.
inline std::uint32_t keep_lanes(std::uint32_t* out, std::uint32_t first, unsigned bits) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  const __m256i lanes = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(first)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), lanes));
  return static_cast<std::uint32_t>(__builtin_popcount(bits));
#else
  std::uint32_t kept = 0;
  for (std::uint32_t lane = 0; lane < 8; ++lane) {
    out[kept] = first + lane;
    kept += bits >> lane & 1;
  }
  return kept;
#endif
}

/// In single precision, to some 1e-7 of itself.
inline F4 rough_square_root(V4 a) {
  const F4 rough = __builtin_convertvector(a, F4);
#if defined(__AVX__)
  return _mm_sqrt_ps(rough);
#else
  return F4{std::sqrt(rough[0]), std::sqrt(rough[1]), std::sqrt(rough[2]), std::sqrt(rough[3])};
#endif
}

/// Rows a b c d become columns x y z w, or back.
inline void transpose(V4& a, V4& b, V4& c, V4& d) {
  const V4 ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const V4 ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const V4 cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const V4 cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// The fourth column of rows a b c d.
inline V4 fourth(V4 a, V4 b, V4 c, V4 d) {
  const V4 ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const V4 cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// `row` with its fourth number taken from `other`.
inline V4 with_fourth(V4 row, V4 other) { return __builtin_shufflevector(row, other, 0, 1, 2, 7); }

struct V4x3 {
  V4 x, y, z;
};
inline V4x3 cross(const V4x3& a, const V4x3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace similitude::pack
