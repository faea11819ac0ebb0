#pragma once
/// @file
/// The motion of a body that nothing pushes, for all times at once: no steps, no error that grows
/// with their number.
///
/// Which closed form it is depends on the body and on how it turns: uniformly about a principal
/// axis (or not at all), as a symmetric top, or as one with three moments.

#include <variant>

#include "tumble/body/free/free_asymmetric_top.hpp"
#include "tumble/body/free/free_symmetric_top.hpp"
#include "tumble/body/free/uniform_rotation.hpp"

namespace tumble {

/// A free body: set up once (about 1 µs), then asked for any time (about 0.1 µs).
///
/// The error of the orientation is below 1e-13 · max(1, |ω| t) rad. (It is the error for the
/// doubles given: near the separatrix another last digit at the start means another motion.)
class FreeMotion {
 public:
  /// @param start q of any length but zero; what comes out is of length 1
  /// @throws std::invalid_argument if a number of the state is not finite, or q is zero
  FreeMotion(const RigidBody<>& body, const RigidBodyState<>& start)
      : start_(start), v_(start.P / body.mass()), rotation_(rotation_of(body, checked(start))) {}

  /// The state at time t [s], of any length and sign; P and L are what they were.
  RigidBodyState<> at(double t) const {
    const Quat q = std::visit([t](const auto& rotation) { return rotation.at(t); }, rotation_);
    return {start_.x + t * v_, q, start_.P, start_.L};
  }

  /// The closed form in words.
  const char* name() const {
    constexpr const char* names[] = {"uniform rotation", "free symmetric top",
                                     "free asymmetric top (elliptic functions)"};
    return names[rotation_.index()];
  }

 private:
  using Rotation = std::variant<UniformRotation, FreeSymmetricTop, FreeAsymmetricTop>;

  static const RigidBodyState<>& checked(const RigidBodyState<>& start) {
    require(pack(start).allFinite(), "FreeMotion: the state (", pack(start).transpose(),
            ") is not finite");
    require(start.q.squaredNorm() > 0, "FreeMotion: the quaternion is zero");
    return start;
  }

  static Rotation rotation_of(const RigidBody<>& body, const RigidBodyState<>& start) {
    const PrincipalAxes axes = principal_axes(body.I_body());
    const Vec3& A = axes.moments;
    if (A[0] == A[2]) return UniformRotation(start.q, start.L / A[0]);
    if (A[0] == A[1] || A[1] == A[2])
      return FreeSymmetricTop(nearest_symmetric_top(axes), start.q, start.L);
    if (const auto polhode = polhode_of(axes, start.q, start.L))
      return FreeAsymmetricTop(*polhode, start.q);
    return UniformRotation(start.q, angular_velocity(body, to_matrix(start.q), start.L));
  }

  RigidBodyState<> start_;
  Vec3 v_;
  Rotation rotation_;
};

}  // namespace tumble
