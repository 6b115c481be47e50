#pragma once
/// The number type of a law: a `double`, or a Pack of as many doubles as the processor handles at once. A law is a
/// template over it and is written once. What differs from plain C++: there is no `if` on a Pack, use select().
///
/// sqrt, cbrt, exp, log, pow, atan, abs, min and max have the same names for both. cbrt, exp, log, pow and atan go lane by
/// lane through the standard library, so a lane's result never depends on its neighbours. Laws use these and select(), not
/// the library's where().

#include <cmath>

// GCC 12's own AVX-512 header reads an undefined register where any value will do, and warns about it in the code that
// calls it (GCC PR 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <experimental/simd>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <similitude/abi.h>
#include <similitude/vec3.h>

namespace similitude {

using Pack = std::experimental::native_simd<double>;
using Mask = Pack::mask_type;
static_assert(SIMILITUDE_ROW_MULTIPLE % Pack::size() == 0, "a block has no remainder rows");

using std::abs;
using std::atan;
using std::cbrt;
using std::exp;
using std::log;
using std::pow;
using std::sqrt;
using std::experimental::abs;
using std::experimental::atan;
using std::experimental::cbrt;
using std::experimental::exp;
using std::experimental::log;
using std::experimental::pow;
using std::experimental::sqrt;

/// For what is called in the middle of a law: one call left in a loop puts all its packs on the stack.
#define SIMILITUDE_INLINE [[gnu::always_inline]] inline

inline double min(double a, double b) { return b < a ? b : a; }
inline double max(double a, double b) { return a < b ? b : a; }
SIMILITUDE_INLINE Pack min(const Pack& a, const Pack& b) { return std::experimental::min(a, b); }
SIMILITUDE_INLINE Pack max(const Pack& a, const Pack& b) { return std::experimental::max(a, b); }

/// `yes` where the condition holds, `no` elsewhere. Both are evaluated.
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
SIMILITUDE_INLINE Pack select(const Mask& condition, const Pack& yes, const Pack& no) {
#if defined(__clang__) && defined(__AVX512F__)
  // Here libstdc++ 12's where() takes all lanes or none (simd_x86.h: "this does a boolean choice, not a blend").
  const auto lanes = static_cast<__mmask8>(condition.__to_bitset().to_ulong());
  return Pack(_mm512_mask_blend_pd(lanes, static_cast<__m512d>(no), static_cast<__m512d>(yes)));
#else
  Pack chosen = no;
  where(condition, chosen) = yes;
  return chosen;
#endif
}
template <class M, class V>
SIMILITUDE_INLINE Vec3<V> select(const M& condition, const Vec3<V>& yes, const Vec3<V>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}

/// The length of a vector. The argument of the root scales by an even power, so a bed scaled by powers of two keeps
/// its bits.
template <class V>
SIMILITUDE_INLINE V magnitude(const Vec3<V>& a) {
  return sqrt(dot(a, a));
}

/// Columns of a block are 64-byte aligned and `row` is a multiple of the pack.
SIMILITUDE_INLINE Pack load(const double* column, std::size_t row) {
  return Pack(column + row, std::experimental::vector_aligned);
}
SIMILITUDE_INLINE void store(const Pack& value, double* column, std::size_t row) {
  value.copy_to(column + row, std::experimental::vector_aligned);
}
SIMILITUDE_INLINE Vec3<Pack> load(const double* const column[3], std::size_t row) {
  return {load(column[0], row), load(column[1], row), load(column[2], row)};
}
SIMILITUDE_INLINE void store(const Vec3<Pack>& value, double* const column[3], std::size_t row) {
  store(value.x, column[0], row);
  store(value.y, column[1], row);
  store(value.z, column[2], row);
}

}  // namespace similitude
