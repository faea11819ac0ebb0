#pragma once
/// @file
/// Where a centre of mass is after any time, when it is pushed by a constant force and held back in
/// proportion to its velocity: no steps.
///
///   v̇ = a − κ v:   v(T) = e^z v + T φ₁(z) a,   x(T) = x + T φ₁(z) v + T² φ₂(z) a,   z = −κ T
///   φ₁(z) = (e^z − 1)/z,   φ₂(z) = (e^z − 1 − z)/z²
///
/// Source: Hochbruck & Ostermann, "Exponential integrators", Acta Numerica 19 (2010), §2.

#include <cmath>

#include "tumble/simd/point.hpp"

namespace tumble::detail::ensembles {

/// What pushes a centre of mass: a − κ v.
template <class P>
struct Push {
  simd::Point<P> acceleration{};  ///< a [m/s²]
  P drag{};                       ///< κ [1/s]
};

/// e^z, φ₁(z) and φ₂(z).
template <class P>
struct Decay {
  P exp, phi1, phi2;
};

/// Of one number.
inline Decay<double> decay(double z) {
  const double phi1 = std::expm1(z) / z;
  return {std::exp(z), phi1, (phi1 - 1) / z};
}

/// Of all lanes: φ₂ by its series Σ zᵏ/(k+2)! for |z| ≤ ½, where the quotients would cancel.
template <class P>
TUMBLE_INLINE Decay<P> decay(const P& z) {
  constexpr int terms = 13;
  double factorial = 1;
  for (int k = 2; k <= terms + 1; ++k) factorial *= k;
  Decay<P> all;
  all.phi2 = P{} + 1 / factorial;
#pragma GCC unroll 16
  for (int k = terms - 2; k >= 0; --k) {
    factorial /= k + 3;
    all.phi2 = all.phi2 * z + 1 / factorial;
  }
  all.phi1 = all.phi2 * z + 1;
  all.exp = all.phi1 * z + 1;
  for (int lane = 0; lane < simd::lanes<P>; ++lane) {
    if (!(std::abs(z[lane]) > 0.5)) continue;
    const Decay<double> one = decay(z[lane]);
    all.exp[lane] = one.exp;
    all.phi1[lane] = one.phi1;
    all.phi2[lane] = one.phi2;
  }
  return all;
}

/// Moves x and v on by the time T [s].
/// @tparam drags whether κ may be anything but 0
template <bool drags, class P>
TUMBLE_INLINE void drift(simd::Point<P>& x, simd::Point<P>& v, const Push<P>& push, double T) {
  const simd::Point<P> gained = T * push.acceleration;
  if constexpr (drags) {
    const Decay<P> d = decay(P(-T * push.drag));
    x = add_scaled(add_scaled(x, P(T * d.phi1), v), P(T * d.phi2), gained);
    v = add_scaled(d.phi1 * gained, d.exp, v);
  } else {
    x = add_scaled(add_scaled(x, T, v), T / 2, gained);
    v = v + gained;
  }
}

}  // namespace tumble::detail::ensembles
