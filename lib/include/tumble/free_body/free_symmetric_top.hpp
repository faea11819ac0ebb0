#pragma once
/// @file
/// Where a body with two equal moments is after any time, when nothing pushes it: sines, no steps.
///
/// ω = L/A + (1/C − 1/A)(L·n) n with n the axis of symmetry, so that
///   q(t) = exp(t L/A) q(0) exp(t (1/C − 1/A)(L·n) n_body)
/// Source: Landau & Lifshitz, "Mechanics" (1976), §33, the regular precession.

#include "tumble/body/model.hpp"
#include "tumble/body/state.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble {

/// @addtogroup free_body
/// @{

namespace detail {

/// The turning of a free symmetric top or ball.
class FreeSymmetricTop {
 public:
  /// @param L angular momentum, world coordinates [kg m²/s]
  FreeSymmetricTop(const SymmetricMoments& top, const Quat& q, const Vec3& L) : q_(q.normalized()) {
    const double slip = (top.transverse - top.axial) / top.axial / top.transverse;  // 1/C − 1/A
    about_L_ = L / top.transverse;
    about_axis_ = slip * L.dot(q_ * top.axis) * top.axis;
  }

  /// Body → world at time t [s], of any length and sign.
  Quat at(double t) const {
    return exp_quaternion<double>(t * about_L_) * q_ * exp_quaternion<double>(t * about_axis_);
  }

 private:
  Quat q_;
  Vec3 about_L_, about_axis_;  ///< [rad/s], world and body coordinates
};

}  // namespace detail

/// The state of a free symmetric top (or ball) after the time t.
/// @param body two of its principal moments must be equal
/// @param t    [s], any length, also negative
/// @throws std::invalid_argument if the body is not symmetric to rounding
RigidBodyState<> free_symmetric_top(const RigidBody<>& body, const RigidBodyState<>& start,
                                    double t);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/free_body/free_symmetric_top.inl"
#endif
