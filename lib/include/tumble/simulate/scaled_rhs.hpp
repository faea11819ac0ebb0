#pragma once
/// @file
/// The equation of motion for a solver that has to be quick, and whose one tolerance has to fit all
/// numbers: (x, q, P, L_body), each measured by its size in the scene.
///
///     d/dt (x, q, P, L_body) = (P/m, ½ q ⟨0, ω_body⟩, F, Rᵀ τ + L_body × ω_body),
///     ω_body = I_body⁻¹ L_body
///
/// L turns with the body, so that ω needs no R; what a force does not look at is not computed.
/// Source: Euler's equations, Landau & Lifshitz, "Mechanics" (1976), §36.

#include "tumble/body/dydt.hpp"
#include "tumble/simulate/stated_error.hpp"

namespace tumble::detail {

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

  Numbers numbers(const RigidBodyState<>& s) const {
    Numbers y;
    y << per_length_ * s.x, coefficients(s.q), per_momentum_ * s.P,
        per_angular_momentum_ * (s.q.conjugate() * s.L);
    return y;
  }

  RigidBodyState<> state(const Numbers& y) const {
    const Quat q = orientation(y).normalized();
    return {scale_.length * y.head<3>(), q, scale_.momentum * y.segment<3>(7),
            q * Vec3(scale_.angular_momentum * y.tail<3>())};
  }

  /// dy/dt at time t [s].
  Numbers operator()(double t, const Numbers& y) const {
    const RigidBody<>& body = rhs_.body();
    const Quat q = orientation(y);
    const Mat3 R = to_matrix(q);
    const Vec3 l = y.tail<3>(), L_body = scale_.angular_momentum * l;
    const Vec3 omega_body = body.I_body_inv() * L_body;
    const Vec3 v = (per_mass_ * scale_.momentum) * y.segment<3>(7);
    const Wrench<> net = rhs_.net(t, {scale_.length * y.head<3>(), R, v, R * omega_body});
    const Vec3 torque = per_angular_momentum_ * net.torque, torque_body = R.transpose() * torque;
    Numbers rate;
    rate << per_length_ * v, coefficients(rotation::quaternion_dot_body(q, omega_body)),
        per_momentum_ * net.force, torque_body + l.cross(omega_body);
    return rate;
  }

 private:
  static Quat orientation(const Numbers& y) { return {y[3], y[4], y[5], y[6]}; }

  Rhs rhs_;
  MotionScale scale_;
  double per_mass_, per_length_, per_momentum_, per_angular_momentum_;
};

}  // namespace tumble::detail
