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

namespace tumble::detail {

/// Sizes of x [m], P [kg m/s] and L [kg m²/s].
struct MotionScale {
  double length, momentum, angular_momentum;
};

/// What is too small to matter, in a span of time: a thousandth of the motion through the body's
/// own size, and of a turn by a radian.
MotionScale least_sizes(const RigidBody<>& body, double span);

/// A motion that is so small beside those sizes is rounding, as of forces that balance each other.
inline constexpr double least_motion = 1e-9;

/// How much of the moments a tensor in turned axes has lost to rounding: finding its axes, or its
/// inverse, leaves of the smallest moment what rounding leaves of the largest.
double rounding_of_moments(const Mat3& I_body, double smallest_moment);

/// |x|², |q|², |P|², |L|² of one body after the other.
template <class Numbers>
using SquaredSizes = Eigen::Matrix < double,
      Numbers::RowsAtCompileTime<0 ? Eigen::Dynamic : 4 * Numbers::RowsAtCompileTime / 13, 1>;

/// Those of thirteen numbers a body.
template <class Numbers>
SquaredSizes<Numbers> squared_sizes(const Numbers& y) {
  const Eigen::Index bodies = y.size() / rigid_body_state_size;
  SquaredSizes<Numbers> squares(4 * bodies);
  for (Eigen::Index b = 0; b < bodies; ++b) {
    const auto of_body = y.template segment<rigid_body_state_size>(rigid_body_state_size * b);
    squares.template segment<4>(4 * b) << of_body.template head<3>().squaredNorm(),
        of_body.template segment<4>(3).squaredNorm(), of_body.template segment<3>(7).squaredNorm(),
        of_body.template tail<3>().squaredNorm();
  }
  return squares;
}

/// What Tolerances are to other problems, for the numbers of one body or of several.
template <class Numbers>
struct MotionTolerance {
  double relative;
  SquaredSizes<Numbers> squares;  ///< of the sizes so far

  /// Takes the sizes of a state that the motion has come to.
  void grow(const Numbers& y) { squares = squares.cwiseMax(squared_sizes(y)); }

  /// The size of a difference, a part of those of the motion; of several bodies, not less than that
  /// of any.
  static double part(const Numbers& difference, const SquaredSizes<Numbers>& sizes) {
    return std::sqrt(squared_sizes(difference).cwiseQuotient(sizes).sum() / 4);
  }
};

/// Found by the solvers beside the one for Tolerances.
template <class Numbers>
double error_norm(const Numbers& error, const Numbers&, const Numbers& y1,
                  const MotionTolerance<Numbers>& tolerance) {
  return MotionTolerance<Numbers>::part(error, tolerance.squares.cwiseMax(squared_sizes(y1))) /
         tolerance.relative;
}

/// The same: x, q, P and L have units of their own, and so no size in common.
template <class Numbers>
Numbers small_sizes(const Numbers& size, double root, const MotionTolerance<Numbers>& tolerance) {
  Numbers small(size.size());
  for (Eigen::Index b = 0; b < size.size() / rigid_body_state_size; ++b) {
    const Eigen::Vector4d sizes = root * tolerance.squares.template segment<4>(4 * b).cwiseSqrt();
    small.template segment<rigid_body_state_size>(rigid_body_state_size * b)
        << Vec3::Constant(sizes[0]),
        Eigen::Vector4d::Constant(sizes[1]), Vec3::Constant(sizes[2]), Vec3::Constant(sizes[3]);
  }
  return small;
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/motion_tolerance.inl"
#endif
