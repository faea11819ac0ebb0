#pragma once
/// @file
/// The flight of a body between two contacts, in closed form: its centre falls, and it turns as a
/// free body does. Bounds on its turning hold for all times.

#include <vector>

#include "tumble/body/derived.hpp"
#include "tumble/collide/bounds.hpp"
#include "tumble/free_body/free_flow.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// How fast a free body can ever turn.
struct TurningBounds {
  double spin = 0;          ///< |ω| at most [rad/s]
  double acceleration = 0;  ///< |dω/dt| at most [rad/s²]
};

/// @}

}  // namespace tumble::contact

namespace tumble::contact::detail {

/// The squares of L's principal components at the ends of what energy and |L| allow, with one of
/// them 0: Lᵢ² + Lⱼ² = L², Lᵢ²/Iᵢ + Lⱼ²/Iⱼ = 2T.
std::vector<Vec3> ends_of_polhodes(const Vec3& I, double L2, double twice_T);

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// Bounds on how fast a body turns as long as no torque acts. The squares of L's components lie on
/// a segment, and both bounds are largest at its ends.
/// @param axes  of the body
/// @param L     [kg m²/s], in principal axes
TurningBounds turning_bounds(const PrincipalAxes& axes, const Vec3& L);

/// A body in flight from a time on.
class Flight {
 public:
  /// @param gravity [m/s²]
  /// @param t0      the time at which `start` holds [s]
  Flight(const RigidBody<>& body, const RigidBodyState<>& start, const Vec3& gravity, double t0)
      : Flight(body, tumble::detail::FreeFlow(body), principal_axes(body.I_body()), start, gravity,
               t0) {}
  /// The same, with what depends on the body alone.
  Flight(const RigidBody<>& body, const tumble::detail::FreeFlow& flow, const PrincipalAxes& axes,
         const RigidBodyState<>& start, const Vec3& gravity, double t0)
      : I_body_inv_(body.I_body_inv()),
        mass_(body.mass()),
        centre_{start.x, start.P / body.mass(), gravity},
        L_(start.L),
        t0_(t0),
        rotation_(flow.from(start.q, start.L)),
        bounds_(turning_bounds(axes,
                               axes.R.transpose() * (to_matrix(start.q).transpose() * start.L))) {}

  Derived<> at(double t) const {
    const double s = t - t0_;
    const Mat3 R = to_matrix(tumble::detail::orientation_at(rotation_, s));
    return {centre_.at(s), R, velocity(s), R * (I_body_inv_ * (R.transpose() * L_))};
  }
  RigidBodyState<> state(double t) const {
    const double s = t - t0_;
    const Quat q = tumble::detail::orientation_at(rotation_, s);
    return {centre_.at(s), q.normalized(), mass_ * velocity(s), L_};
  }
  /// Whether it stays where it is.
  bool is_still() const { return centre_.v.isZero(0) && centre_.a.isZero(0) && L_.isZero(0); }
  Vec3 acceleration() const { return centre_.a; }
  double most_spin() const { return bounds_.spin; }
  double most_angular_acceleration() const { return bounds_.acceleration; }

  /// What a ball around the centre passes from t to t + duration.
  collide::Bounds swept(double t, double duration, double radius) const {
    const double s = t - t0_;
    return collide::swept_bounds({centre_.at(s), velocity(s), centre_.a}, duration, radius);
  }

 private:
  Vec3 velocity(double s) const { return centre_.v + s * centre_.a; }

  Mat3 I_body_inv_;
  double mass_;
  collide::Parabola centre_;
  Vec3 L_;
  double t0_;
  tumble::detail::FreeRotation rotation_;
  TurningBounds bounds_;
};

/// @}

}  // namespace tumble::contact

#ifndef TUMBLE_COMPILED
#include "tumble/contact/flight.inl"
#endif
