#pragma once
/// @file
/// The heavy symmetric top in closed form: a body with two equal moments A and a third C, pulled by
/// a constant force at a point of its axis. (About a fixed point on its axis, with the moments for
/// that point, it is the same.)
///
/// With w = 1 − cos θ, θ between the axis n and the direction e away from the force, μ the largest
/// torque, and the constants L_n = L·n, L_e = L·e, D = L_e − L_n,
///
///     A² ẇ² = 2 A (ε + μ w) w (2 − w) − (D + L_n w)² = 2 A μ (w − w₃)(w − w₂)(w₁ − w)
///     w = w₁ − (w₁ − w₂) sn² v,   v = λ t + v₀,   λ² = μ (w₁ − w₃)/2A,   k² = (w₁ − w₂)/(w₁ − w₃)
///
/// The orientation's Cayley–Klein parameters a and b have |a|² = 1 − w/2, |b|² = w/2 and the angles
/// α and β, each an integral of the third kind, here by theta functions:
///
///     α̇ = (L_e + L_n)/(2 A (2 − w)) + s/2,   β̇ = D/(2 A w) − s/2,   s = L_n (1/C − 1/A)
///
/// Source: Whittaker, "A Treatise on the Analytical Dynamics of Particles and Rigid Bodies" (4th
/// ed. 1937), §71–72; Klein & Sommerfeld, "The Theory of the Top" II (2010), ch. VI, for a and b.

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <variant>

#include "tumble/elliptic/complementary_theta_series.hpp"
#include "tumble/elliptic/theta_series.hpp"
#include "tumble/steady/steady_torque.hpp"
#include "tumble/steady/top_constants.hpp"

namespace tumble::steady {

/// @addtogroup steady
/// @{

/// The closed form of a top's turning.
class LagrangeTop {
 public:
  /// Where it is: orientation and angular momentum, in world coordinates.
  struct State {
    Quat q;
    Vec3 L;
  };

  /// The top of these forces, or nothing: if it is none, or if its axis passes so close to the
  /// vertical that the closed form loses digits.
  /// @param q unit quaternion
  static std::optional<LagrangeTop> from(const SteadyTorque& torque, const Quat& q, const Vec3& L);

  /// How fast the axis rises and falls [rad/s].
  double rate() const { return lambda_; }

  /// What the orientation's error stays below [rad]: the more, the closer the axis passes to the
  /// vertical.
  double error_bound(double t) const {
    const double rate =
        std::hypot(motion_.L_axis, motion_.L_along) / motion_.A + lambda_ + std::abs(slip_);
    return 2e-15 * loss_ * std::max(1.0, rate * std::abs(t));
  }

  /// @param t [s], of any length and sign
  State at(double t) const {
    const double v = lambda_ * t + v0_;
    const elliptic::ThetaValues va = values(alpha_, v), vb = values(beta_, v + K_);
    const double w = motion_.w2 + motion_.spread * va.cn * va.cn,
                 up_to_2 = 2 - motion_.w1 + motion_.spread * va.sn * va.sn;  // 2 − w
    const std::complex<double> a =
        std::sqrt(up_to_2 / 2) * a0_ * turn(sign_a_, rate_a_, slip_, va, t);
    const std::complex<double> b = std::sqrt(w / 2) * b0_ * turn(sign_b_, rate_b_, -slip_, vb, t);
    const Quat q = upright_ * Quat(a.real(), b.real(), b.imag(), a.imag()) * frame_;
    const double w_rate = -2 * motion_.spread * lambda_ * va.sn * va.cn * va.dn;
    return {q.normalized(), momentum(q * axis_, w, w_rate)};
  }

 private:
  using Theta = std::variant<elliptic::ThetaSeries, elliptic::ComplementaryThetaSeries>;

  LagrangeTop(const detail::TopConstants& motion, const Vec3& up, const Vec3& axis, double slip);

  static Theta series_for(const elliptic::Modulus& k, const elliptic::Amplitude& eta) {
    if (k.k2 <= k.kc2) return elliptic::ThetaSeries(k, eta);
    return elliptic::ComplementaryThetaSeries(k, eta);
  }
  static elliptic::ThetaValues values(const Theta& theta, double v) {
    return std::visit([v](const auto& series) { return series(v); }, theta);
  }
  static double zeta(const Theta& theta) {
    return std::visit([](const auto& series) { return series.zeta(); }, theta);
  }

  /// e^(i angle) at time t, but for a constant.
  static std::complex<double> turn(double sign, double rate, double slip,
                                   const elliptic::ThetaValues& v, double t) {
    const std::complex<double> half(v.cos_half, sign * v.sin_half);
    return std::polar(1.0, (sign * rate + slip) * t + sign * v.turned) * half * half;
  }

  /// L from its components along the axis, upwards and across.
  Vec3 momentum(const Vec3& n, double w, double w_rate) const {
    const double u = 1 - w, sin2 = w * (2 - w);
    const double along_n = (motion_.L_axis * w - motion_.excess * u) / sin2;
    const double along_up = (motion_.excess + motion_.L_axis * w) / sin2;
    return along_n * n + along_up * up_ + (motion_.A * w_rate / sin2) * up_.cross(n);
  }

  detail::TopConstants motion_;
  Vec3 up_, axis_;  ///< e in the world, n in the body
  Quat upright_;    ///< z → e
  Quat frame_;      ///< body → coordinates with n along z
  double slip_;     ///< s/2 [rad/s]
  double lambda_, v0_, K_, loss_;
  Theta alpha_, beta_;
  double sign_a_, sign_b_, rate_a_, rate_b_;
  std::complex<double> a0_ = 1, b0_ = 1;
};

/// @}

}  // namespace tumble::steady

#ifndef TUMBLE_COMPILED
#include "tumble/steady/lagrange_top.inl"
#endif
