#pragma once
/// @file
/// Between which angles the axis of a heavy symmetric top rises and falls: the roots of the cubic
/// in lagrange_top.hpp.
///
/// Two roots may nearly meet, where the axis hardly nutates. So the cubic is solved with twice the
/// digits: its least root first, then what is left, a quadratic.
///
/// Source: Whittaker, "A Treatise on the Analytical Dynamics of Particles and Rigid Bodies" (4th
/// ed. 1937), §71.

#include <cmath>
#include <optional>

#include "tumble/body/exact_omega.hpp"
#include "tumble/core/types.hpp"
#include "tumble/elliptic/modulus.hpp"
#include "tumble/simd/double_double.hpp"

namespace tumble::detail {

/// The constants of a top's motion and the turning points of its axis.
struct TopConstants {
  double A, mu;                    ///< [kg m²], [N m]
  double L_axis, L_along, excess;  ///< L_n, L_e and D = L_e − L_n [kg m²/s]
  double w1, w2, w3;               ///< of 1 − cos θ: w₃ ≤ 0 ≤ w₂ ≤ w ≤ w₁ ≤ 2
  double spread;                   ///< w₁ − w₂
  elliptic::Amplitude start;       ///< sn v₀, cn v₀

  double lambda() const { return std::sqrt(mu * (w1 - w3) / (2 * A)); }  ///< dv/dt [1/s]
  elliptic::Modulus modulus() const { return {spread / (w1 - w3), (w2 - w3) / (w1 - w3)}; }
  /// η of the angles α and β.
  elliptic::Amplitude eta_a() const {
    return {std::sqrt((w1 - w3) / (2 - w3)), std::sqrt((2 - w1) / (2 - w3))};
  }
  elliptic::Amplitude eta_b() const {
    return {std::sqrt(-w3 / (w2 - w3)), std::sqrt(w2 / (w2 - w3))};
  }
};

/// √x with twice the digits, x ≥ 0.
simd::DoubleDouble square_root(const simd::DoubleDouble& x);

/// The least root of w³ + c₂ w² + c₁ w + c₀, whose roots are real: Newton from the left of it.
simd::DoubleDouble least_root(const simd::DoubleDouble& c2, const simd::DoubleDouble& c1,
                              const simd::DoubleDouble& c0);

/// sn v₀ and cn v₀ where the axis is so far from its turning points and rises so fast.
/// @param back, down w − w₂ and w₁ − w
elliptic::Amplitude starting_amplitude(const TopConstants& m, double back, double down,
                                       double rise);

/// The turning points of the axis, or nothing if one is too close to the vertical.
/// @param L, up in the top's coordinates, its axis along z
std::optional<TopConstants> top_constants(double A, double mu, const Vec3dd& L, const Vec3dd& up);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/steady/top_constants.inl"
#endif
