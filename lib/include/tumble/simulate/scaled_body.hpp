#pragma once
/// @file
/// A body's part of the equation of motion for a solver that has to be quick: (x, q, P, l), q and
/// l = Rᵀ L in principal axes, each measured by what it may become in the scene, so that no square
/// of it leaves the range of doubles.
///
///     d/dt (x, q, P, l) = (P/m, ½ q ⟨0, ω⟩, F, Rᵀ τ + l × ω),   ωᵢ = lᵢ/Jᵢ,
///     (l × ω)₁ = (J₂ − J₃)/(J₂ J₃) l₂ l₃
///
/// l turns with the body, so that ω needs no R. With the inverse tensor of a needle in other axes,
/// or as a difference of products, l × ω would have no right digit about the needle's axis.
/// Source: Euler's equations, Landau & Lifshitz, "Mechanics" (1976), §36.

#include "tumble/body/derived.hpp"
#include "tumble/body/wrench.hpp"
#include "tumble/free_body/polhode.hpp"
#include "tumble/mass/principal_axes.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"
#include "tumble/simulate/motion_tolerance.hpp"

namespace tumble::detail {

/// What may become of a motion in the whole time: units, not more.
/// @param net what acts on the body at the start
MotionScale units_of(const RigidBody<>& body, const RigidBodyState<>& start, const Wrench<>& net,
                     double span);

/// The axes in which a body's tensor is diagonal: its own where it is, so that nothing is turned.
inline PrincipalAxes diagonal_axes(const Mat3& I_body) {
  if (I_body.isDiagonal(0)) return {I_body.diagonal(), Mat3::Identity()};
  return principal_axes(I_body);
}

/// A body in its units.
class ScaledBody {
 public:
  using Numbers = PackedState<double>;

  /// A motion at one moment, as its rate needs it.
  struct Moving {
    Mat3 R;         ///< principal axes → world
    Vec3 omega;     ///< in principal axes [rad/s]
    Derived<> now;  ///< all that a force may depend on, but the time
  };

  ScaledBody(const RigidBody<>& body, const MotionScale& scale)
      : scale_(scale),
        axes_(diagonal_axes(body.I_body())),
        is_turned_(!body.I_body().isDiagonal(0)),
        frame_(is_turned_ ? from_matrix(axes_.R) : Quat::Identity()),
        lost_moments_(rounding_of_moments(body.I_body(), axes_.moments.minCoeff())),
        per_mass_(1 / body.mass()),
        per_length_(1 / scale.length),
        per_momentum_(1 / scale.momentum),
        per_angular_momentum_(1 / scale.angular_momentum) {
    const Vec3& J = axes_.moments;
    omega_ = (scale.angular_momentum / J.array()).matrix();
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      euler_[i] = (J[j] - J[k]) / J[j] * omega_[k];
    }
  }

  /// How much of the moments their rounding has taken.
  double lost_moments() const { return lost_moments_; }

  Numbers numbers(const RigidBodyState<>& s) const {
    const Vec3dd L = principal_momentum(axes_, s.q, s.L);
    Numbers y;
    y << per_length_ * s.x, coefficients(Quat(s.q.normalized() * frame_)), per_momentum_ * s.P,
        per_angular_momentum_ * Vec3(L[0].hi, L[1].hi, L[2].hi);
    return y;
  }

  RigidBodyState<> state(const Numbers& y) const {
    const Quat q = orientation(y).normalized();
    return {scale_.length * y.head<3>(), is_turned_ ? Quat(q * frame_.conjugate()) : q,
            scale_.momentum * y.segment<3>(7), q * Vec3(scale_.angular_momentum * y.tail<3>())};
  }

  /// |ω| [rad/s].
  double omega(const Numbers& y) const { return omega_.cwiseProduct(y.tail<3>()).norm(); }

  /// The squares of sizes, in these units.
  Eigen::Vector4d squares(const MotionScale& sizes) const {
    const Eigen::Vector4d parts(per_length_ * sizes.length, 1, per_momentum_ * sizes.momentum,
                                per_angular_momentum_ * sizes.angular_momentum);
    return parts.cwiseAbs2();
  }

  Moving moving(const Numbers& y) const {
    const Mat3 R = to_matrix(orientation(y));
    const Vec3 omega = omega_.cwiseProduct(y.tail<3>());
    Moving moving{R,
                  omega,
                  {scale_.length * y.head<3>(), R, (per_mass_ * scale_.momentum) * y.segment<3>(7),
                   R * omega}};
    if (is_turned_) moving.now.R = R * axes_.R.transpose();
    return moving;
  }

  /// dy/dt.
  Numbers rate(const Numbers& y, const Moving& moving, const Wrench<>& net) const {
    const Vec3 l = y.tail<3>();
    // L × ω, by differences of moments that lose no digit.
    const Vec3 turned(euler_[0] * l[1] * l[2], euler_[1] * l[2] * l[0], euler_[2] * l[0] * l[1]);
    const Vec3 torque = per_angular_momentum_ * net.torque;
    Numbers rate;
    rate << per_length_ * moving.now.v,
        coefficients(rotation::quaternion_dot_body(orientation(y), moving.omega)),
        per_momentum_ * net.force, moving.R.transpose() * torque + turned;
    return rate;
  }

 private:
  static Quat orientation(const Numbers& y) { return {y[3], y[4], y[5], y[6]}; }

  MotionScale scale_;
  PrincipalAxes axes_;
  bool is_turned_;
  Quat frame_;  ///< principal axes → the body's own
  Vec3 omega_, euler_;
  double lost_moments_;
  double per_mass_, per_length_, per_momentum_, per_angular_momentum_;
};

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/scaled_body.inl"
#endif
