#pragma once
/// @file
/// Bodies whose turning is known to all digits of a double.

#include <cmath>
#include <numbers>

#include "tumble/body/steady_forces.hpp"
#include "tumble/free_body/free_flow.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace scene_chapter {

using namespace tumble;

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// The turn by |w| about w, both in radians.
inline Quat turn(const Vec3& w) { return exp_quaternion<double>(w); }

/// A body that turns about its middle or a pivot, what turns it, and where it is in the end, to
/// all digits of a double: by Taylor series with 60 digits, as in lib/reference/rigid_body.hpp.
struct KnownTurning {
  RigidBody<> body;
  RigidBodyState<> start;
  SteadyForces forces;  ///< torques only: what holds the pivot keeps the rest
  double duration;      ///< [s]
  Quat end;
};

/// At the pivot or, if nothing is held there, at the centre of mass.
inline RigidBodyState<> turning_state(const RigidBody<>& body, const Quat& q, const Vec3& omega) {
  return {Vec3::Zero(), q, Vec3::Zero(), q * Vec3(body.I_body() * omega)};
}

inline KnownTurning known_turning(const Vec3& moments, const Quat& q, const Vec3& omega,
                                  const SteadyForces& forces, double duration, const Quat& end) {
  const RigidBody<> body(1, moments.asDiagonal());
  return {body, turning_state(body, q, omega), forces, duration, end};
}

/// The torque of a weight of `newton` at a point, about the pivot.
inline SteadyForces held_weight(double newton, const Vec3& p_body) {
  return {Vec3::Zero(), {{Vec3(0, 0, -newton), p_body}}, 0, 0};
}

/// Free, and nearly about the middle axis.
inline const KnownTurning& flipping_body() {
  static const KnownTurning scene = known_turning(
      {1, 2, 3}, Quat(1, 0, 0, 0), {1e-3, 2, 1e-3}, {}, 100,
      Quat(-0.071789099212623476, 0.49189772662808386, 0.041722294314205268, 0.86668460349167494));
  return scene;
}

/// A fast top about its pivot, its axis ½ rad off the vertical.
inline const KnownTurning& fast_top() {
  static const KnownTurning scene = known_turning(
      {1, 1, 0.5}, Quat(std::cos(0.25), std::sin(0.25), 0, 0), {0.25, 0, 40},
      held_weight(5, {0, 0, 1}), 10,
      Quat(0.60632751143978144, -0.24316993627936017, -0.069505036537402224, -0.75392597836731088));
  return scene;
}

/// A body about a pivot that is on none of its axes: no closed form is known.
inline const KnownTurning& lopsided_body() {
  static const KnownTurning scene = known_turning(
      {1, 2, 3}, Quat(std::cos(0.25), std::sin(0.25), 0, 0), {0.3, -2, 5},
      held_weight(5, {0.6, 0, 0.8}), 10,
      Quat(-0.076589873022445239, 0.36502392592671639, 0.17171180500162740, 0.91181499267918153));
  return scene;
}

/// Free, with a closed form as the truth.
inline KnownTurning free_turning(const Vec3& moments, const Vec3& omega, double duration) {
  KnownTurning scene =
      known_turning(moments, Quat(std::cos(0.25), std::sin(0.25), 0, 0), omega, {}, duration, {});
  const tumble::detail::FreeFlow flow(scene.body);
  scene.end = flow.advance(scene.start.q, scene.start.L, duration);
  return scene;
}

}  // namespace scene_chapter
