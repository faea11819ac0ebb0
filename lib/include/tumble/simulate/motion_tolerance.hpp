#pragma once
/// @file
/// The sizes of a motion, and the error that a step may make: of each of x, q, P and L a part of
/// the largest that it has been on the way.
///
/// The largest so far is known at every step; what it will be is not, and a guess from rates and
/// times may be wrong by as many digits as one likes (a body on a stiff spring).

#include <cmath>

#include "tumble/body/rigid_body.hpp"
#include "tumble/body/state.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::detail {

/// Sizes of x [m], P [kg m/s] and L [kg m²/s].
struct MotionScale {
  double length, momentum, angular_momentum;
};

/// What is too small to matter, in a span of time: a thousandth of the motion through the body's
/// own size, and of a turn by a radian.
inline MotionScale least_sizes(const RigidBody<>& body, double span) {
  constexpr double small = 1e-3;
  const double inertia = body.I_body().trace() / 3;
  const double length = small * std::sqrt(inertia / body.mass());
  return {length, body.mass() * length / span, small * inertia / span};
}

/// How much of the moments a tensor in turned axes has lost to rounding: finding its axes, or its
/// inverse, leaves of the smallest moment what rounding leaves of the largest.
inline double rounding_of_moments(const Mat3& I_body, double smallest_moment) {
  if (I_body.isDiagonal(0)) return 0;
  constexpr double roundings = 4;
  return roundings * unit_roundoff * I_body.trace() / smallest_moment;
}

/// |x|², |q|², |P|², |L|² of thirteen numbers.
inline Eigen::Vector4d squared_sizes(const PackedState<double>& y) {
  return {y.head<3>().squaredNorm(), y.segment<4>(3).squaredNorm(), y.segment<3>(7).squaredNorm(),
          y.tail<3>().squaredNorm()};
}

/// What Tolerances are to other problems, for the thirteen numbers of a motion.
struct MotionTolerance {
  double relative;
  Eigen::Vector4d squares;  ///< of the sizes so far

  /// Takes the sizes of a state that the motion has come to.
  void grow(const PackedState<double>& y) { squares = squares.cwiseMax(squared_sizes(y)); }

  /// The size of a difference, a part of those of the motion.
  static double part(const PackedState<double>& difference, const Eigen::Vector4d& sizes) {
    return std::sqrt(squared_sizes(difference).cwiseQuotient(sizes).sum() / 4);
  }
};

/// Found by the solvers beside the one for Tolerances.
inline double error_norm(const PackedState<double>& error, const PackedState<double>&,
                         const PackedState<double>& y1, const MotionTolerance& tolerance) {
  return MotionTolerance::part(error, tolerance.squares.cwiseMax(squared_sizes(y1))) /
         tolerance.relative;
}

}  // namespace tumble::detail
