#pragma once
/// @file
/// The sums over a mesh that its integrals' rounding errors are bounded by, and the proof.
///
/// Let every + − × have a relative error of at most u (of what is added, not of the sum: |x| +
/// |y|). An expression of + − × is a sum of products of its inputs; one that passes k operations on
/// its way comes out wrong by less than γ_k = k u / (1 − k u) of itself. So the result is wrong by
/// less than γ_k times what comes out if all inputs are replaced by their absolute values and each
/// − by + (Higham, §3.1). For one triangle (tetrahedron.hpp):
///
///   6V = (e × f) · a                   3 differences of corners, ×, −, ×, +, +            k =  8
///   6V s_x                             a difference, +, +, and ×                          k = 12
///   6V (s_x s_y + a_x a_y + …)         2 (a difference, +, +), ×, +, and ×                k = 17
///
/// Their absolute values are, with A = Σ_x |a_x| (|e_y| |f_z| + |e_z| |f_y|) and q = |a|² + |b|² +
/// |c|²: A for the first; for the vector 6V s at most A (|a| + |b| + |c|) ≤ A √(3 q); for the
/// matrix at most A ((|a| + |b| + |c|)² + q) ≤ 4 A q, in the Frobenius norm. All three follow from
/// two sums over the mesh, Σ A and Σ A q, because Σ A √q ≤ √(Σ A · Σ A q).
///
/// Adding up: a lane adds 8 terms (7 roundings: the first one is added to 0), and these go into a
/// pair of doubles. From there on errors are some u². So k = 15, 19, 24; one more covers γ, u², and
/// the rounding of the sums themselves, whose terms are all positive.
///
/// In pairs of doubles an operation leaves an error of a pair with the low part l u, l the number
/// of operations so far: the low parts are rounded, and one product is left out. By induction k
/// operations are wrong by at most k² u² of the absolute values; at 24 + 16 additions of short sums
/// that is 1600 u². Then at most 8 lanes, 32 blocks and n / 2¹⁴ sums of blocks are added in
/// double-double, 3 u² each.

#include <cmath>

#include "tumble/core/rounding.hpp"
#include "tumble/mass/error_bound.hpp"
#include "tumble/simd/point.hpp"

namespace tumble::detail {

/// Σ A and Σ A q, of T.
template <class T>
struct RoundingSums {
  T volume{};  ///< Σ A [m³]
  T second{};  ///< Σ A q [m⁵]

  /// A triangle a, b, c, from the reference point, with the edges e and f from a.
  TUMBLE_INLINE void add(const simd::Point<T>& a, const simd::Point<T>& b, const simd::Point<T>& c,
                         const simd::Point<T>& e, const simd::Point<T>& f) {
    using simd::absolute;
    const T ex = absolute(e.x), ey = absolute(e.y), ez = absolute(e.z);
    const T fx = absolute(f.x), fy = absolute(f.y), fz = absolute(f.z);
    const T A = absolute(a.x) * (ey * fz + ez * fy) + absolute(a.y) * (ez * fx + ex * fz) +
                absolute(a.z) * (ex * fy + ey * fx);
    const T q = (a.x * a.x + b.x * b.x + c.x * c.x) + (a.y * a.y + b.y * b.y + c.y * c.y) +
                (a.z * a.z + b.z * b.z + c.z * c.z);
    volume += A;
    second += A * q;
  }

  RoundingSums& operator+=(const RoundingSums& other) {
    volume += other.volume;
    second += other.second;
    return *this;
  }
};

/// The errors of the integrals, if those of the three kinds of sums are k₀, k₁ and k₂ times the
/// sums of absolute values.
inline IntegralErrors integral_errors(const RoundingSums<double>& sums, double k0, double k1,
                                      double k2) {
  return {k0 * sums.volume / 6, k1 * std::sqrt(3 * sums.volume) * std::sqrt(sums.second) / 24,
          k2 * 4 * sums.second / 120};
}

/// The errors after a sum in doubles.
inline IntegralErrors errors_in_doubles(const RoundingSums<double>& sums) {
  return integral_errors(sums, 16 * unit_roundoff, 20 * unit_roundoff, 25 * unit_roundoff);
}

/// The errors after a sum in pairs of doubles.
/// @param triangles how many were added
inline IntegralErrors errors_in_pairs(const RoundingSums<double>& sums, double triangles) {
  const double k = (2048 + triangles * 0x1p-12) * unit_roundoff * unit_roundoff;
  return integral_errors(sums, k, k, k);
}

}  // namespace tumble::detail
