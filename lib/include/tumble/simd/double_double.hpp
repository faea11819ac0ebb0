#pragma once
/// @file
/// A number as the unevaluated sum hi + lo of two doubles: about 32 decimal digits.
///
/// Unlike a Pair it is normalised after each operation, so that nothing is lost however long the
/// computation. Source: Joldes, Muller & Popescu, "Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic", ACM TOMS 44(2), 2017: algorithms 4, 6, 7, 11, 17.
/// Relative error at most 3u² for a sum, 7u² for a product, 15u² for a quotient, u = 2⁻⁵³.

#include "tumble/core/types.hpp"
#include "tumble/simd/pair.hpp"

namespace tumble::simd {

/// @addtogroup simd
/// @{

/// hi + lo with |lo| at most half a unit in the last place of hi.
struct DoubleDouble {
  double hi = 0, lo = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double x) : hi(x) {}  // implicit: every double is one
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}
  DoubleDouble(const detail::Pair<double>& x) : DoubleDouble(normalised(x.hi, x.lo)) {}
  explicit constexpr operator double() const { return hi + lo; }

 private:
  static constexpr DoubleDouble normalised(double high, double low) {
    const double sum = high + low;
    return {sum, low - (sum - high)};
  }
};

inline DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi, -x.lo}; }

inline DoubleDouble operator+(const DoubleDouble& x, double y) {
  const DoubleDouble s = detail::two_sum(x.hi, y);
  return detail::fast_two_sum(s.hi, x.lo + s.lo);
}

inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble s = detail::two_sum(x.hi, y.hi), t = detail::two_sum(x.lo, y.lo);
  const DoubleDouble v = detail::fast_two_sum(s.hi, s.lo + t.hi);
  return detail::fast_two_sum(v.hi, t.lo + v.lo);
}

inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

inline DoubleDouble operator*(const DoubleDouble& x, double y) {
  const DoubleDouble p = detail::two_prod(x.hi, y);
  const DoubleDouble s = detail::fast_two_sum(p.hi, x.lo * y);
  return detail::fast_two_sum(s.hi, s.lo + p.lo);
}

inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble p = detail::two_prod(x.hi, y.hi);
  return detail::fast_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  const double quotient = x.hi / y.hi;
  const DoubleDouble product = y * quotient;
  const double rest = (x.hi - product.hi) + (x.lo - product.lo);
  return detail::fast_two_sum(quotient, rest / y.hi);
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

/// @}

}  // namespace tumble::simd

namespace Eigen {

/// Lets Eigen's small vectors and matrices hold double-doubles.
template <>
struct NumTraits<tumble::simd::DoubleDouble> : GenericNumTraits<tumble::simd::DoubleDouble> {
  static tumble::simd::DoubleDouble epsilon() { return 0x1p-104; }
  static tumble::simd::DoubleDouble dummy_precision() { return 0x1p-96; }
  static int digits10() { return 31; }
};

}  // namespace Eigen
