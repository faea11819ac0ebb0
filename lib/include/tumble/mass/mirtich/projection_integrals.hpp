#pragma once
/// @file
/// Mirtich's first level: integrals over a plane polygon become sums over its
/// edges (Green's theorem).
///
/// ∬ αⁱ βʲ dα dβ = 1/(i+1) ∮ αⁱ⁺¹ βʲ dβ, and = −1/(j+1) ∮ αⁱ βʲ⁺¹ dα; along an edge both are
/// polynomials. Source: Mirtich, "Fast and Accurate Computation of Polyhedral Mass Properties",
/// Journal of Graphics Tools 1(2), 1996: §4.4 (theorem 4 and the integrals that it needs).

#include <span>

#include "tumble/core/types.hpp"

namespace tumble::mirtich {

/// @addtogroup mass
/// @{

/// π_f = ∬ f(α, β) dα dβ over a polygon, for the monomials f up to the third degree that are
/// needed. Positive area where the corners go round counter-clockwise in the (α, β) plane.
struct ProjectionIntegrals {
  double one = 0, a = 0, b = 0;               ///< of 1, α, β                [m² m³ m³]
  double aa = 0, ab = 0, bb = 0;              ///< of α², αβ, β²             [m⁴]
  double aaa = 0, aab = 0, abb = 0, bbb = 0;  ///< of α³, α²β, αβ², β³  [m⁵]
};

/// Σ_k x^k y^(n−k), k = 0…n: what ∫ of the n-th power along an edge from x to y comes to, times
/// n + 1.
inline double power_sum(double x, double y, int n) {
  double sum = 1, power = 1;
  for (int k = 1; k <= n; ++k) {
    power *= y;
    sum = sum * x + power;
  }
  return sum;
}

/// Adds the contribution of the edge from p to q, without the common factors.
inline void add_edge(ProjectionIntegrals& sum, const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  const double a0 = p.x(), b0 = p.y(), a1 = q.x(), b1 = q.y();
  const double da = a1 - a0, db = b1 - b0;
  sum.one += db * power_sum(a0, a1, 1);
  sum.a += db * power_sum(a0, a1, 2);
  sum.aa += db * power_sum(a0, a1, 3);
  sum.aaa += db * power_sum(a0, a1, 4);
  sum.b -= da * power_sum(b0, b1, 2);
  sum.bb -= da * power_sum(b0, b1, 3);
  sum.bbb -= da * power_sum(b0, b1, 4);
  // The mixed ones: ∫ α² β, ∫ α³ β and ∫ α β³ along the edge, each end weighted as it is near.
  sum.ab += db * (b0 * (3 * a0 * a0 + 2 * a0 * a1 + a1 * a1) +
                  b1 * (a0 * a0 + 2 * a0 * a1 + 3 * a1 * a1));
  sum.aab += db * (b0 * (((4 * a0 + 3 * a1) * a0 + 2 * a1 * a1) * a0 + a1 * a1 * a1) +
                   b1 * (((4 * a1 + 3 * a0) * a1 + 2 * a0 * a0) * a1 + a0 * a0 * a0));
  sum.abb -= da * (a0 * (((4 * b0 + 3 * b1) * b0 + 2 * b1 * b1) * b0 + b1 * b1 * b1) +
                   a1 * (((4 * b1 + 3 * b0) * b1 + 2 * b0 * b0) * b1 + b0 * b0 * b0));
}

/// The projection integrals of a polygon: of its shadow, seen along the axis γ. It may
/// have any shape.
/// @param corners in order [m]
/// @param gamma   0, 1 or 2 for x, y or z; α = γ + 1 and β = γ + 2, modulo 3
inline ProjectionIntegrals projection_integrals(std::span<const Vec3> corners, int gamma) {
  const int alpha = (gamma + 1) % 3, beta = (gamma + 2) % 3;
  ProjectionIntegrals sum;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3 &from = corners[k], &to = corners[k + 1 < corners.size() ? k + 1 : 0];
    add_edge(sum, {from[alpha], from[beta]}, {to[alpha], to[beta]});
  }
  sum.one /= 2;
  sum.a /= 6;
  sum.b /= 6;
  sum.aa /= 12;
  sum.ab /= 24;
  sum.bb /= 12;
  sum.aaa /= 20;
  sum.aab /= 60;
  sum.abb /= 60;
  sum.bbb /= 20;
  return sum;
}

/// @}

}  // namespace tumble::mirtich
