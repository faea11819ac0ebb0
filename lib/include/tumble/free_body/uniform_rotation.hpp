#pragma once
/// @file
/// A body that turns about a principal axis, or not at all: ω stays what it is.
///
///     q(t) = exp(ω t) q(0)
///
/// Source: Landau & Lifshitz, "Mechanics" (1976), §37.

#include "tumble/body/derived.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::detail {

/// The orientation of a body with constant angular velocity.
class UniformRotation {
 public:
  /// @param omega angular velocity, world coordinates [rad/s]
  UniformRotation(const Quat& q, const Vec3& omega) : q_(q.normalized()), omega_(omega) {}

  Quat at(double t) const { return exp_quaternion<double>(t * omega_) * q_; }

 private:
  Quat q_;
  Vec3 omega_;
};

}  // namespace tumble::detail
