#pragma once
/// @file
/// The equation of motion for a solver that has to be quick: (x, q, P, L_body), each measured by
/// what it may become in the scene, so that no square of it leaves the range of doubles.
///
///     d/dt (x, q, P, L_body) = (P/m, ½ q ⟨0, ω_body⟩, F, Rᵀ τ + L_body × ω_body),
///     ω_body = I_body⁻¹ L_body
///
/// L turns with the body, so that ω needs no R; what a force does not look at is not computed.
/// Source: Euler's equations, Landau & Lifshitz, "Mechanics" (1976), §36.

#include <algorithm>

#include "tumble/body/dydt.hpp"
#include "tumble/free_body/polhode.hpp"
#include "tumble/simulate/motion_tolerance.hpp"

namespace tumble::detail {

/// What may become of a motion in the whole time: units, not more.
template <class Rhs>
MotionScale units_of(const Rhs& rhs, const RigidBodyState<>& start, double t0, double span) {
  const RigidBody<>& body = rhs.body();
  const RigidBodyState<> rate = rhs.rate(t0, start);
  const MotionScale least = least_sizes(body, span);
  MotionScale scale;
  scale.momentum = std::max({start.P.norm(), rate.P.norm() * span, least.momentum});
  scale.length =
      std::max({start.x.norm(), scale.momentum / body.mass() * span, least.length});
  scale.angular_momentum =
      std::max({start.L.norm(), rate.L.norm() * span, least.angular_momentum});
  return scale;
}

/// A right-hand side of a body under forces.
/// @tparam Rhs a RigidBodyRhs<double, …>
template <class Rhs>
class ScaledRhs {
 public:
  using Numbers = PackedState<double>;

  ScaledRhs(const Rhs& rhs, const MotionScale& scale)
      : rhs_(rhs),
        scale_(scale),
        per_mass_(1 / rhs.body().mass()),
        per_length_(1 / scale.length),
        per_momentum_(1 / scale.momentum),
        per_angular_momentum_(1 / scale.angular_momentum) {}

  const RigidBody<>& body() const { return rhs_.body(); }

  Numbers numbers(const RigidBodyState<>& s) const {
    const Vec3dd L_body = into_body(s.q, s.L);
    Numbers y;
    y << per_length_ * s.x, coefficients(s.q.normalized()), per_momentum_ * s.P,
        per_angular_momentum_ * Vec3(L_body[0].hi, L_body[1].hi, L_body[2].hi);
    return y;
  }

  RigidBodyState<> state(const Numbers& y) const {
    const Quat q = orientation(y).normalized();
    return {scale_.length * y.head<3>(), q, scale_.momentum * y.segment<3>(7),
            q * Vec3(scale_.angular_momentum * y.tail<3>())};
  }

  /// |ω| [rad/s].
  double omega(const Numbers& y) const {
    return scale_.angular_momentum * (rhs_.body().I_body_inv() * y.tail<3>()).norm();
  }

  /// The squares of sizes, in these units.
  Eigen::Vector4d squares(const MotionScale& sizes) const {
    const Eigen::Vector4d parts(per_length_ * sizes.length, 1, per_momentum_ * sizes.momentum,
                                per_angular_momentum_ * sizes.angular_momentum);
    return parts.cwiseAbs2();
  }

  /// All that a force may depend on, but the time.
  Derived<> motion(const Numbers& y) const {
    const Mat3 R = to_matrix(orientation(y));
    const Vec3 omega_body = rhs_.body().I_body_inv() * (scale_.angular_momentum * y.tail<3>());
    return {scale_.length * y.head<3>(), R, velocity(y), R * omega_body};
  }
  Wrench<> net(double t, const Derived<>& now) const { return rhs_.net(t, now); }

  /// dy/dt at time t [s].
  Numbers operator()(double t, const Numbers& y) const {
    const Quat q = orientation(y);
    const Mat3 R = to_matrix(q);
    const Vec3 l = y.tail<3>(), L_body = scale_.angular_momentum * l;
    const Vec3 omega_body = rhs_.body().I_body_inv() * L_body;
    const Vec3 v = velocity(y);
    const Wrench<> net = rhs_.net(t, {scale_.length * y.head<3>(), R, v, R * omega_body});
    const Vec3 torque = per_angular_momentum_ * net.torque, torque_body = R.transpose() * torque;
    Numbers rate;
    rate << per_length_ * v, coefficients(rotation::quaternion_dot_body(q, omega_body)),
        per_momentum_ * net.force, torque_body + l.cross(omega_body);
    return rate;
  }

 private:
  Vec3 velocity(const Numbers& y) const {
    return (per_mass_ * scale_.momentum) * y.segment<3>(7);
  }
  static Quat orientation(const Numbers& y) { return {y[3], y[4], y[5], y[6]}; }

  Rhs rhs_;
  MotionScale scale_;
  double per_mass_, per_length_, per_momentum_, per_angular_momentum_;
};

}  // namespace tumble::detail
