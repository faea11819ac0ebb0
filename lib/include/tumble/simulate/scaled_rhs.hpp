#pragma once
/// @file
/// The equation of motion for a solver that has to be quick: (x, q, P, l), q and l = Rᵀ L in
/// principal axes, each measured by what it may become in the scene, so that no square of it leaves
/// the range of doubles.
///
///     d/dt (x, q, P, l) = (P/m, ½ q ⟨0, ω⟩, F, Rᵀ τ + l × ω),   ωᵢ = lᵢ/Jᵢ,
///     (l × ω)₁ = (J₂ − J₃)/(J₂ J₃) l₂ l₃
///
/// l turns with the body, so that ω needs no R. With the inverse tensor of a needle in other axes,
/// or as a difference of products, l × ω would have no right digit about the needle's axis.
/// Source: Euler's equations, Landau & Lifshitz, "Mechanics" (1976), §36.

#include <algorithm>

#include "tumble/body/dydt.hpp"
#include "tumble/free_body/polhode.hpp"
#include "tumble/mass/principal_axes.hpp"
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
  scale.length = std::max({start.x.norm(), scale.momentum / body.mass() * span, least.length});
  scale.angular_momentum = std::max({start.L.norm(), rate.L.norm() * span, least.angular_momentum});
  return scale;
}

/// The axes in which a body's tensor is diagonal: its own where it is, so that nothing is turned.
inline PrincipalAxes diagonal_axes(const Mat3& I_body) {
  if (I_body.isDiagonal(0)) return {I_body.diagonal(), Mat3::Identity()};
  return principal_axes(I_body);
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
        axes_(diagonal_axes(rhs.body().I_body())),
        is_turned_(!rhs.body().I_body().isDiagonal(0)),
        frame_(is_turned_ ? from_matrix(axes_.R) : Quat::Identity()),
        per_mass_(1 / rhs.body().mass()),
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

  const RigidBody<>& body() const { return rhs_.body(); }
  double smallest_moment() const { return axes_.moments.minCoeff(); }

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

  /// All that a force may depend on, but the time.
  Derived<> motion(const Numbers& y) const {
    return derived_from(y, to_matrix(orientation(y)), omega_.cwiseProduct(y.tail<3>()));
  }
  Wrench<> net(double t, const Derived<>& now) const { return rhs_.net(t, now); }

  /// dy/dt at time t [s].
  TUMBLE_FLATTEN Numbers operator()(double t, const Numbers& y) const {
    const Quat q = orientation(y);
    const Mat3 R = to_matrix(q);
    const Vec3 l = y.tail<3>(), omega = omega_.cwiseProduct(l);
    const Derived<> now = derived_from(y, R, omega);
    const Wrench<> net = rhs_.net(t, now);
    // L × ω, by differences of moments that lose no digit.
    const Vec3 turned(euler_[0] * l[1] * l[2], euler_[1] * l[2] * l[0], euler_[2] * l[0] * l[1]);
    const Vec3 torque = per_angular_momentum_ * net.torque;
    Numbers rate;
    rate << per_length_ * now.v, coefficients(rotation::quaternion_dot_body(q, omega)),
        per_momentum_ * net.force, R.transpose() * torque + turned;
    return rate;
  }

 private:
  static Quat orientation(const Numbers& y) { return {y[3], y[4], y[5], y[6]}; }

  /// @param R, omega in principal axes
  Derived<> derived_from(const Numbers& y, const Mat3& R, const Vec3& omega) const {
    Derived<> now{scale_.length * y.head<3>(), R, (per_mass_ * scale_.momentum) * y.segment<3>(7),
                  R * omega};
    if (is_turned_) now.R = R * axes_.R.transpose();
    return now;
  }

  Rhs rhs_;
  MotionScale scale_;
  PrincipalAxes axes_;
  bool is_turned_;
  Quat frame_;  ///< principal axes → the body's own
  Vec3 omega_, euler_;
  double per_mass_, per_length_, per_momentum_, per_angular_momentum_;
};

}  // namespace tumble::detail
