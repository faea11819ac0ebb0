#pragma once
/// @file
/// Several doubles that go through the same arithmetic side by side: a Pack.
///
/// These are the vector types that gcc and clang have on every processor: + − * work on all lanes,
/// no instruction is called by name, and what is wider than the registers is split. (They are used
/// as they are: wrapped into a class, gcc copies them piece by piece.)
/// Source: GCC manual, "Using Vector Instructions through Built-in Functions".

#include <cmath>
#include <cstring>

#include "tumble/core/inline.hpp"

#if !defined(__GNUC__) || (!defined(__clang__) && __GNUC__ < 12)
#error "tumble/simd/pack.hpp: gcc 12 or newer, or clang, is needed"
#endif

/// Code that exists once, however often it is called. In a copy of it a compiler may fuse other
/// products with other sums, and so round otherwise.
#if defined(__clang__)
#define TUMBLE_ONE_COPY __attribute__((noinline))
#else
#define TUMBLE_ONE_COPY __attribute__((noipa))
#endif

// Packs are passed to inlined functions only, so no calling convention is involved. gcc says so
// where the file that includes this one ends, which is why this holds to the end.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace tumble::simd {

/// @addtogroup simd
/// @{

using FourDoubles = double __attribute__((vector_size(32)));
using EightDoubles = double __attribute__((vector_size(64)));

/// Four doubles from anywhere in memory.
TUMBLE_INLINE FourDoubles load_four(const double* from) {
  FourDoubles four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

/// How many doubles a Pack has.
template <class P>
inline constexpr int lanes = static_cast<int>(sizeof(P) / sizeof(double));

/// The integers that belong to a Pack.
template <class P>
struct IntegersOf;
/// Beside four doubles.
template <>
struct IntegersOf<FourDoubles> {
  using Long = unsigned long long __attribute__((vector_size(32)));
  using Short = int __attribute__((vector_size(16)));
};
/// Beside eight doubles.
template <>
struct IntegersOf<EightDoubles> {
  using Long = unsigned long long __attribute__((vector_size(64)));
  using Short = int __attribute__((vector_size(32)));
};
/// As many integers of 64 bits; sums and products are modulo 2⁶⁴.
template <class P>
using Integers = typename IntegersOf<P>::Long;
/// As many ints.
template <class P>
using Ints = typename IntegersOf<P>::Short;

/// |x| in each lane.
template <class P>
TUMBLE_INLINE P absolute(const P& x) {
  const auto all_but_sign = Integers<P>{} + 0x7fffffffffffffff;
  return reinterpret_cast<P>(reinterpret_cast<Integers<P>>(x) & all_but_sign);
}

TUMBLE_INLINE double absolute(double x) { return std::abs(x); }

/// 1 in the lanes where x ≤ y or one of both is NaN, 0 in the others.
template <class P>
TUMBLE_INLINE P one_unless_greater(const P& x, const P& y) {
  return x > y ? P{} : P{} + 1;
}

/// The smaller number of each lane.
template <class P>
TUMBLE_INLINE P smaller(const P& x, const P& y) {
  return x < y ? x : y;
}
/// The larger number of each lane.
template <class P>
TUMBLE_INLINE P larger(const P& x, const P& y) {
  return x > y ? x : y;
}

/// The whole number next to each, for |x| < 2⁵¹.
template <class P>
TUMBLE_INLINE P rounded(const P& x) {
  const P large = P{} + 0x1.8p52;  // where doubles are whole
  return (x + large) - large;
}

/// The sum of all lanes.
TUMBLE_INLINE double sum_of_lanes(const FourDoubles& x) { return (x[0] + x[2]) + (x[1] + x[3]); }
TUMBLE_INLINE double sum_of_lanes(const EightDoubles& x) {
  const FourDoubles halves =
      __builtin_shufflevector(x, x, 0, 1, 2, 3) + __builtin_shufflevector(x, x, 4, 5, 6, 7);
  return sum_of_lanes(halves);
}

/// Whether a·b + c has an instruction of its own, with one rounding.
enum class Fma { separate, fused };

#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
inline constexpr Fma baseline_fma = Fma::fused;
#else
inline constexpr Fma baseline_fma = Fma::separate;  // std::fma would be a slow call
#endif

TUMBLE_INLINE double fused_multiply_add(double a, double b, double c) { return std::fma(a, b, c); }

/// a·b + c with one rounding, in each lane. (The compiler makes one instruction of the loop.)
template <class P>
TUMBLE_INLINE P fused_multiply_add(const P& a, const P& b, const P& c) {
  P result{};
  for (int i = 0; i < lanes<P>; ++i) result[i] = __builtin_fma(a[i], b[i], c[i]);
  return result;
}

/// @}

}  // namespace tumble::simd
