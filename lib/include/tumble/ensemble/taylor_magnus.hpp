#pragma once
/// @file
/// Steps by power series: the Taylor series of the angular velocity by recurrence, and from it the
/// turn by its Magnus series. Nothing is evaluated at stages, and q keeps its length by itself.
///
///   (k + 1) b_x[k+1] = asymmetry_x Σᵢ b_y[i] b_z[k−i] + (h² I⁻¹ τ)_x[k],   and so on for y, z
///
/// A step of order 4 costs what one of RK4 on (q, ω) costs, less under a torque, and errs as much
/// or less; one of order 6 costs 1.7 times as much, of order 8 3.3 times.
/// Source: the recurrence as in Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations
/// I", 2nd ed. (1993), §I.8.

#include "tumble/ensemble/magnus.hpp"
#include "tumble/ensemble/stepper.hpp"

namespace tumble {

/// @addtogroup ensemble
/// @{

/// The series method of order N = 4, 6 or 8, for advance(): for the library's own forces.
template <int N>
struct TaylorMagnus {
  static_assert(N == 4 || N == 6 || N == 8, "TaylorMagnus<N>: N is 4, 6 or 8");
  static constexpr int order = N;
};

namespace detail::ensembles {

/// By the series of ω and the turn that it makes.
template <int N, class P, class Kernels>
class Stepper<TaylorMagnus<N>, P, Kernels> {
 public:
  static constexpr std::size_t terms = N + 1;
  static_assert(Kernels::steady, "TaylorMagnus: a force of your own has no series here; use Rk4");

  template <class Forces>
  TUMBLE_INLINE void begin(const EightMotions& from, int lane, const ensemble::PackBody<P>& body,
                           const Forces& forces, double h) {
    kernels_.prepare(forces, body, h);
    spin_ = load_spin<P>(from.spins, lane, h);
    begin_ = spin_.b;
    for (int k = 0; k < N; ++k) asymmetry_over_[k] = 1.0 / (k + 1) * body.asymmetry;
  }

  TUMBLE_INLINE void step(double) {
    Point<P> b[terms];
    b[0] = spin_.b;
    typename Kernels::template Series<N> torques;
    kernels_.template start<N>(torques, spin_.q);
#pragma GCC unroll 16
    for (int k = 0; k < N; ++k) {
      b[k + 1] = scaled_axes(asymmetry_over_[k], cyclic_products_of_series(b, k));
      kernels_.template add<N>(torques, k, b, b[k + 1]);
    }
    spin_.q = spin_.q * exp_small(rotation_vector(b));
    // The small terms first.
    Point<P> change = b[N];
#pragma GCC unroll 16
    for (int k = N - 1; k > 0; --k) change = change + b[k];
    spin_.b = spin_.b + change;
  }

  TUMBLE_INLINE void end(const EightMotions& to, int lane, double h, int steps) const {
    store_spin(spin_, begin_, to.spins, lane, h);
    store_drift<P>(kernels_, to.paths, lane, h * steps);
  }

 private:
  /// Coefficient k of (b_y b_z, b_z b_x, b_x b_y).
  TUMBLE_INLINE static Point<P> cyclic_products_of_series(const Point<P> (&b)[terms], int k) {
    Point<P> sum = cyclic_products(b[0], b[k]);
#pragma GCC unroll 16
    for (int i = 1; i <= k; ++i) {
      sum.x = sum.x + b[i].y * b[k - i].z;
      sum.y = sum.y + b[i].z * b[k - i].x;
      sum.z = sum.z + b[i].x * b[k - i].y;
    }
    return sum;
  }

  Kernels kernels_;
  Spin<P> spin_;
  Point<P> begin_;                           // spin_.b before the first step
  Point<P> asymmetry_over_[std::size_t{N}];  // 1, 2, … N
};

}  // namespace detail::ensembles

/// @}

}  // namespace tumble
