#pragma once
/// @file
/// How some bodies turn: orientation and h ω, and what drives them.
///
///   q′ = ½ q ⟨0, b⟩,   b′ = diag(asymmetry) (b_y b_z, b_z b_x, b_x b_y) + h² I⁻¹ τ,   b = h ω
///
/// about the principal axes, where no tensor has to be turned. ′ is d/ds; a step is s = 0 … 1.
/// Source: Euler's equations, Landau & Lifshitz, "Mechanics" (1976), §36, eq. 36.5.

#include "tumble/ensemble/eights.hpp"

namespace tumble::detail::ensembles {

using simd::Point;
using simd::Quaternion;

/// The turning of some bodies.
template <class P>
struct Spin {
  Quaternion<P> q;  ///< principal axes → world
  Point<P> b;       ///< h ω
};

/// (b_y b_z, b_z b_x, b_x b_y) of two moments of a spin.
template <class P>
TUMBLE_INLINE Point<P> cyclic_products(const Point<P>& b, const Point<P>& c) {
  return {b.y * c.z, b.z * c.x, b.x * c.y};
}

template <class P>
TUMBLE_INLINE Spin<P> load_spin(const EightSpins& from, int lane, double h) {
  return {load<P>(from.q, lane), h * load<P>(from.omega, lane)};
}

/// velocity + (end − begin)/h of a velocity times h: without a change it keeps its last bit.
template <class P>
TUMBLE_INLINE Point<P> changed(const Point<P>& velocity, const Point<P>& begin, const Point<P>& end,
                               double h) {
  return add_scaled(velocity, 1 / h, end - begin);
}

/// @param begin the b that was loaded
template <class P>
TUMBLE_INLINE void store_spin(const Spin<P>& spin, const Point<P>& begin, EightSpins& to, int lane,
                              double h) {
  store(nearly_normalised(spin.q), to.q, lane);
  store(changed(load<P>(to.omega, lane), begin, spin.b, h), to.omega, lane);
}

}  // namespace tumble::detail::ensembles
