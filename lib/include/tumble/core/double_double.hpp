#pragma once
/// @file
/// A number as the unevaluated sum hi + lo of two doubles: about 32 decimal digits.
///
/// Error-free transformations: a + b = s + e and a·b = p + e hold exactly, e a double.
/// Source: Joldes, Muller & Popescu, "Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic", ACM TOMS 44(2), 2017: algorithms 1–4, 6, 7, 11 and 17.
/// Relative error at most 3u² for a sum, 7u² for a product, 15u² for a quotient, u = 2⁻⁵³.

#include <cmath>

#include "tumble/core/types.hpp"

#ifdef __FAST_MATH__
#error "tumble/double_double.hpp: -ffast-math takes the error terms away; compile without it"
#endif

namespace tumble {

/// hi + lo with |lo| at most half a unit in the last place of hi.
struct DoubleDouble {
  double hi = 0, lo = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double x) : hi(x) {}  // implicit: every double is one
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}
  explicit constexpr operator double() const { return hi + lo; }
};

/// a + b exactly, if |a| ≥ |b| or a = 0 (Fast2Sum, 3 operations).
inline DoubleDouble fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a + b exactly (2Sum, 6 operations).
inline DoubleDouble two_sum(double a, double b) {
  const double s = a + b;
  const double b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}

/// a − b exactly.
inline DoubleDouble two_diff(double a, double b) { return two_sum(a, -b); }

#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
/// a·b exactly, unless it underflows (2Prod: the processor has a fused multiply-add).
inline DoubleDouble two_prod(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}
#else
/// x as the exact sum of two numbers of 26 bits (Veltkamp), for |x| < 2⁹⁹⁶.
inline DoubleDouble split(double x) {
  const double scaled = 134217729.0 * x;  // 2²⁷ + 1
  const double hi = scaled - (scaled - x);
  return {hi, x - hi};
}

/// a·b exactly, unless it underflows (Dekker: where std::fma would be a slow library call).
inline DoubleDouble two_prod(double a, double b) {
  const double p = a * b;
  const DoubleDouble x = split(a), y = split(b);
  return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}
#endif

// ── Arithmetic ──

inline DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi, -x.lo}; }

inline DoubleDouble operator+(const DoubleDouble& x, double y) {
  const DoubleDouble s = two_sum(x.hi, y);
  return fast_two_sum(s.hi, x.lo + s.lo);
}

inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi), t = two_sum(x.lo, y.lo);
  const DoubleDouble v = fast_two_sum(s.hi, s.lo + t.hi);
  return fast_two_sum(v.hi, t.lo + v.lo);
}

inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

inline DoubleDouble operator*(const DoubleDouble& x, double y) {
  const DoubleDouble p = two_prod(x.hi, y);
  const DoubleDouble s = fast_two_sum(p.hi, x.lo * y);
  return fast_two_sum(s.hi, s.lo + p.lo);
}

inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble p = two_prod(x.hi, y.hi);
  return fast_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  const double quotient = x.hi / y.hi;
  const DoubleDouble product = y * quotient;
  const double rest = (x.hi - product.hi) + (x.lo - product.lo);
  return fast_two_sum(quotient, rest / y.hi);
}

inline DoubleDouble& operator+=(DoubleDouble& x, double y) { return x = x + y; }
inline DoubleDouble& operator+=(DoubleDouble& x, const DoubleDouble& y) { return x = x + y; }
inline DoubleDouble& operator-=(DoubleDouble& x, const DoubleDouble& y) { return x = x - y; }
inline DoubleDouble& operator*=(DoubleDouble& x, const DoubleDouble& y) { return x = x * y; }

inline bool operator==(const DoubleDouble& x, const DoubleDouble& y) {
  return x.hi == y.hi && x.lo == y.lo;
}
inline bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
  return x.hi < y.hi || (x.hi == y.hi && x.lo < y.lo);
}

}  // namespace tumble

namespace Eigen {

/// Lets Eigen's small vectors and matrices hold double-doubles.
template <>
struct NumTraits<tumble::DoubleDouble> : GenericNumTraits<tumble::DoubleDouble> {
  static tumble::DoubleDouble epsilon() { return 0x1p-104; }
  static tumble::DoubleDouble dummy_precision() { return 0x1p-96; }
  static int digits10() { return 31; }
};

}  // namespace Eigen
