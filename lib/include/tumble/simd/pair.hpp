#pragma once
/// @file
/// Numbers that carry their rounding errors along: hi + lo, computed from operations whose error is
/// a number of the same kind and so can be had exactly.
///
/// T is a double, or a Pack of doubles that go through the same operations side by side.
/// Source: Knuth, "The Art of Computer Programming" 2 (3rd ed. 1997), §4.2.2 (sum); Dekker, "A
/// floating-point technique for extending the available precision", Numer. Math. 18 (1971)
/// (product); Lange & Rump, "Faithfully rounded floating-point computations", ACM TOMS 46(3),
/// 2020 (arithmetic on pairs that are never normalised: CPairSum, CPairProd).

#include <cmath>

#include "tumble/simd/pack.hpp"

#ifdef __FAST_MATH__
#error "tumble/simd/pair.hpp: -ffast-math takes the error terms away; compile without it"
#endif

namespace tumble::detail {

using simd::Fma;

/// hi + lo; lo is of the size of hi's rounding, or of a few of them.
/// @tparam T   double or a Pack
/// @tparam fma how products are computed
template <class T, Fma fma = simd::baseline_fma>
struct Pair {
  T hi{}, lo{};
};

// ── Operations without an error ──

/// a + b exactly, if |a| ≥ |b| or a = 0 (Fast2Sum, 3 operations).
template <Fma fma = simd::baseline_fma, class T>
TUMBLE_INLINE Pair<T, fma> fast_two_sum(const T& a, const T& b) {
  const T s = a + b;
  return {s, b - (s - a)};
}

/// a + b exactly (2Sum, 6 operations).
template <Fma fma = simd::baseline_fma, class T>
TUMBLE_INLINE Pair<T, fma> two_sum(const T& a, const T& b) {
  const T s = a + b;
  const T b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}

/// a − b exactly.
template <Fma fma = simd::baseline_fma, class T>
TUMBLE_INLINE Pair<T, fma> two_diff(const T& a, const T& b) {
  const T d = a - b;
  const T b_part = d - a;
  return {d, (a - (d - b_part)) - (b + b_part)};
}

/// x as the exact sum of two numbers of 26 bits (Veltkamp), for |x| < 2⁹⁹⁶.
template <class T>
TUMBLE_INLINE Pair<T> split(const T& x) {
  const T scaled = x * 134217729.0;  // 2²⁷ + 1
  const T hi = scaled - (scaled - x);
  return {hi, x - hi};
}

/// a·b exactly, unless it underflows (2Prod: with a fused multiply-add where there is one, else
/// after Dekker).
template <Fma fma = simd::baseline_fma, class T>
TUMBLE_INLINE Pair<T, fma> two_prod(const T& a, const T& b) {
  const T p = a * b;
  if constexpr (fma == Fma::fused) {
    const T minus_p = -p;
    return {p, simd::fused_multiply_add(a, b, minus_p)};
  } else {
    const Pair<T> x = split(a), y = split(b);
    return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
  }
}

// ── Arithmetic of pairs: relative errors of a few 2⁻¹⁰⁶ where nothing cancels ──

template <class T, Fma fma>
TUMBLE_INLINE Pair<T, fma> operator+(const Pair<T, fma>& x, const Pair<T, fma>& y) {
  const Pair<T, fma> s = two_sum<fma>(x.hi, y.hi);
  return {s.hi, s.lo + (x.lo + y.lo)};
}
template <class T, Fma fma>
TUMBLE_INLINE Pair<T, fma> operator-(const Pair<T, fma>& x, const Pair<T, fma>& y) {
  const Pair<T, fma> s = two_diff<fma>(x.hi, y.hi);
  return {s.hi, s.lo + (x.lo - y.lo)};
}
template <class T, Fma fma>
TUMBLE_INLINE Pair<T, fma> operator*(const Pair<T, fma>& x, const Pair<T, fma>& y) {
  const Pair<T, fma> p = two_prod<fma>(x.hi, y.hi);
  return {p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi)};
}
template <class T, Fma fma>
TUMBLE_INLINE Pair<T, fma>& operator+=(Pair<T, fma>& x, const Pair<T, fma>& y) {
  return x = x + y;
}
template <class T, Fma fma>
TUMBLE_INLINE Pair<T, fma>& operator+=(Pair<T, fma>& x, const T& y) {
  const Pair<T, fma> s = two_sum<fma>(x.hi, y);
  return x = {s.hi, s.lo + x.lo};
}

// ── Products and sums, whatever the numbers ──

/// a·b + c; for doubles with one rounding where there is an instruction for it.
template <Fma fma = simd::baseline_fma, class T>
TUMBLE_INLINE T multiply_add(const T& a, const T& b, const T& c) {
  if constexpr (fma == Fma::fused) {
    return simd::fused_multiply_add(a, b, c);
  } else {
    return a * b + c;
  }
}
template <Fma, class T, Fma fma>
TUMBLE_INLINE Pair<T, fma> multiply_add(const Pair<T, fma>& a, const Pair<T, fma>& b,
                                        const Pair<T, fma>& c) {
  return a * b + c;
}

}  // namespace tumble::detail
