#pragma once
/// @file
/// A body that is held at one of its points by a ball joint: a top on its tip, a pendulum.
///
/// About the point that stays, L̇ = τ holds as about the centre of mass, with the tensor about that
/// point (parallel axes). So a held body is a body that only turns, and everything that turns
/// bodies turns it too: a symmetric top under its weight has a closed form.
///
/// Source: Goldstein, Poole & Safko, "Classical Mechanics" (2002), §5.7: the heavy top with one
/// point fixed.

#include "tumble/body/derived.hpp"
#include "tumble/body/exact_omega.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/core/require.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/quaternion/normalize.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// A body and the point at which it is held.
class HeldBody {
 public:
  /// @param held the point that stays, from the centre of mass [m], body coordinates
  /// @throws std::invalid_argument if it is not finite
  HeldBody(const RigidBody<>& body, const Vec3& held)
      : body_(body), held_(held), about_point_(body.mass(), tensor_about(body, held)) {}

  const RigidBody<>& body() const { return body_; }
  const Vec3& held() const { return held_; }

  /// The body that turns about the point, as if that were its centre of mass.
  const RigidBody<>& about_point() const { return about_point_; }

  /// The state of the held body while its point is at `point` [m]: x and P are those of its centre
  /// of mass, L is about the centre of mass.
  /// @param q any length but zero
  RigidBodyState<> state(const Vec3& point, const Quat& q, const Vec3& omega) const {
    const Mat3 R = to_matrix(detail::of_moderate_length(q));
    const Vec3 from_point = -R * held_;
    return {point + from_point, q, body_.mass() * omega.cross(from_point),
            angular_momentum(body_, R, omega)};
  }

  /// The same motion as a turning about the point: x is the point's place, P is 0, L is about it.
  /// Of a slim body it keeps digits of ω that L about the centre of mass has no room for.
  RigidBodyState<> turning(const Vec3& point, const Quat& q, const Vec3& omega) const {
    const Mat3 R = to_matrix(detail::of_moderate_length(q));
    return {point, q, Vec3::Zero(), angular_momentum(about_point_, R, omega)};
  }

  /// The turning that a state of the centre of mass is.
  /// @throws std::invalid_argument if the point moves
  RigidBodyState<> turning_of(const RigidBodyState<>& state) const {
    const Quat q = detail::of_moderate_length(state.q);
    const Mat3 R = to_matrix(q);
    const Vec3 omega_body = detail::exact_omega(body_, q, state.L);
    const Derived<> now{state.x, R, state.P / body_.mass(), R * omega_body};
    const Vec3 v = point_velocity(now, held_);
    constexpr double slack = 1e-12;  // of the speeds that cancel
    require(v.norm() <= slack * (now.v.norm() + now.omega.norm() * held_.norm()) +
                            rounding_of_omega(now, state.L) * held_.norm(),
            "held body: the point that is held moves at (", v.transpose(), ") m/s");
    return {point_position(now, held_), state.q, Vec3::Zero(),
            R * (about_point_.I_body() * omega_body)};
  }

  /// The state whose turning about the point this is.
  RigidBodyState<> state_of(const RigidBodyState<>& turning) const {
    return state(turning.x, turning.q, derived(about_point_, turning).omega);
  }

 private:
  /// How far rounding leaves ω uncertain [rad/s]: a needle's spin about itself is what remains of
  /// L, and its tensor in turned axes has lost digits of the smallest moment.
  double rounding_of_omega(const Derived<>& now, const Vec3& L) const {
    constexpr double roundings = 16;
    const Mat3& I = body_.I_body();
    const double largest_L = I.isDiagonal(0) ? L.norm() : I.trace() * now.omega.norm();
    return roundings * detail::unit_roundoff * body_.I_body_inv().norm() * largest_L;
  }

  static Mat3 tensor_about(const RigidBody<>& body, const Vec3& held) {
    require(held.allFinite(), "held body: the point (", held.transpose(), ") is not finite");
    return parallel_axis(body.I_body(), body.mass(), held);
  }

  RigidBody<> body_;
  Vec3 held_;
  RigidBody<> about_point_;
};

namespace detail {

/// What a force on a body does to its turning about the point where it is held: the joint takes up
/// the force, the torque about the point remains.
template <class Force>
struct TorqueAboutPoint {
  HeldBody held;
  Force force;

  Wrench<> operator()(double t, const RigidBody<>&, const Derived<>& turning) const {
    const Vec3 from_point = -turning.R * held.held();
    const Derived<> now{turning.x + from_point, turning.R, turning.omega.cross(from_point),
                        turning.omega};
    const Wrench<> wrench = force(t, held.body(), now);
    return {.torque = wrench.torque + from_point.cross(wrench.force)};
  }
  void require_valid() const { require_valid_force(force); }
};

/// The same of steady forces without linear drag, which are steady again.
SteadyForces about_point(const HeldBody& held, const SteadyForces& forces);

}  // namespace detail

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/body/held_body.inl"
#endif
