#pragma once
/// @file
/// The motion of a body that nothing pushes, for all times at once: no steps, no error that grows
/// with their number.
///
/// Which closed form it is depends on the body and on how it turns: uniformly about a principal
/// axis (or not at all), as a symmetric top, or as one with three moments.

#include "tumble/free_body/free_flow.hpp"

namespace tumble {

/// @addtogroup free_body
/// @{

/// A free body: set up once (about 1 µs), then asked for any time (about 0.1 µs).
///
/// The error of the orientation is below 1e-13 · max(1, |ω| t) rad. (It is the error for the
/// doubles given: near the separatrix another last digit at the start means another motion. If the
/// tensor is not diagonal, what rounding leaves of its axes is another start: see simulate(), which
/// states what comes of it.)
class FreeTrajectory {
 public:
  /// @param start q of any length but zero; what comes out is of length 1
  /// @throws std::invalid_argument if a number of the state is not finite, or q is zero
  FreeTrajectory(const RigidBody<>& body, const RigidBodyState<>& start)
      : start_(checked(start)),
        v_(start.P / body.mass()),
        rotation_(detail::FreeFlow(body).from(start.q, start.L)) {}

  /// The state at time t [s], of any length and sign; P and L are what they were.
  RigidBodyState<> at(double t) const {
    return {start_.x + t * v_, detail::orientation_at(rotation_, t), start_.P, start_.L};
  }

  /// The closed form in words.
  friend const char* name_of(const FreeTrajectory& motion) {
    constexpr const char* names[] = {"uniform rotation", "free symmetric top",
                                     "free asymmetric top (elliptic functions)"};
    return names[motion.rotation_.index()];
  }

 private:
  static const RigidBodyState<>& checked(const RigidBodyState<>& start) {
    require(pack(start).allFinite(), "FreeTrajectory: the state (", pack(start).transpose(),
            ") is not finite");
    require(start.q.squaredNorm() > 0, "FreeTrajectory: the quaternion is zero");
    return start;
  }

  RigidBodyState<> start_;
  Vec3 v_;
  detail::FreeRotation rotation_;
};

/// @}

}  // namespace tumble
