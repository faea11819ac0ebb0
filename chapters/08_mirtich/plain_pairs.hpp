#pragma once
/// @file
/// Sums and products of doubles with their rounding errors, for the page.

#include <cmath>

namespace mirtich_chapter {

/// A rounded value, and what the rounding lost.
struct TwoDoubles {
  double value, lost;
};

/// a + b, exactly.
inline TwoDoubles two_sum(double a, double b) {
  const double s = a + b;
  const double b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}

/// a b, exactly.
inline TwoDoubles two_prod(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

}  // namespace mirtich_chapter
