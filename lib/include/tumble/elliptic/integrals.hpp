#pragma once
/// @file
/// Elliptic integrals of the first kind, complete and not, each by a mean that converges
/// quadratically or better.
///
///     R_F(x, y, z) = ½ ∫₀^∞ ds / √((s + x)(s + y)(s + z)),   K(k) = R_F(0, 1 − k², 1)
///
/// Source: Carlson, "Numerical computation of real or complex elliptic integrals", Numerical
/// Algorithms 10 (1995), algorithm 1; NIST Digital Library of Mathematical Functions, §19.8 and
/// §19.25.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tumble::detail {

/// Carlson's R_F, to a few units in the last place.
/// @param x, y, z not negative, at most one of them 0; ∞ if two are
inline double carlson_rf(double x, double y, double z) {
  const double mean0 = (x + y + z) / 3;
  double mean = mean0, power = 1;  // power = 4⁻ⁿ
  // (3 r)^(−1/6) of the paper, r = 2⁻⁵³ / 8
  double spread = 600 * std::max({std::abs(mean0 - x), std::abs(mean0 - y), std::abs(mean0 - z)});
  const double x0 = x, y0 = y;
  while (spread * power > std::abs(mean)) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    const double lambda = rx * (ry + rz) + ry * rz;
    if (lambda == 0) return std::numeric_limits<double>::infinity();
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    mean = (mean + lambda) / 4;
    power /= 4;
  }
  const double X = (mean0 - x0) * power / mean, Y = (mean0 - y0) * power / mean, Z = -X - Y;
  const double E2 = X * Y - Z * Z, E3 = X * Y * Z;
  return (1 + E2 * (-1.0 / 10 + E2 / 24 - E3 * 3 / 44) + E3 / 14) / std::sqrt(mean);
}

}  // namespace tumble::detail

namespace tumble::elliptic {

/// @addtogroup elliptic
/// @{

/// The complete integral K for the complementary modulus k' = √(1 − k²), which says more near
/// k = 1 than k does: K = π / (2 agm(1, k')).
/// @param kc k' in 0 … 1; ∞ for 0
inline double complete_elliptic_k(double kc) {
  if (kc == 0) return std::numeric_limits<double>::infinity();
  double a = 1, b = kc;
  while (std::abs(a - b) > 1e-8 * a) {  // the next mean has twice the digits
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::numbers::pi / (a + b);
}

/// @}

}  // namespace tumble::elliptic
