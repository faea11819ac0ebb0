#pragma once
/// @file
/// Where a body with three different moments is after any time, when nothing pushes it: elliptic
/// functions, no steps.
///
/// With the principal moments J₁, J₂, J₃ so named that the body turns about axis 3 (J₃ is the
/// largest or the smallest), G = |L| and T the energy, the direction m of L in the body is
///
///     m = (m̂₁ cn u, m̂₂ sn u, m̂₃ dn u),   u = λ t + u₀,   λ² = (J₃ − J₂)(G² − 2 T J₁) / (J₁ J₂ J₃)
///
/// and what is left is the angle φ about L. With the body's axis p as the pole, φ̇ is a rational
/// function of m_p², whose integral is that of the third kind; in theta functions
///
///     p = 3:  φ = (G/J₁ − λ ζ) t + arg Θ(u + iη),   sn(η, k') = m̂₃
///     p = 1:  φ = (G/J₃ + λ ζ) t − arg Θ(u + iη),   sn²(η, k') = J₁ (J₃ − J₂) / (J₂ (J₃ − J₁))
///
/// with ζ = Z(iη, k)/i. The pole is chosen so that L never comes near it: then nothing is lost
/// whether the body turns nearly about an axis, nearly about the middle one, or is nearly round.
///
/// Source: Landau & Lifshitz, "Mechanics" (1976), §37; van Zon & Schofield, "Numerical
/// implementation of the exact dynamics of free rigid bodies", J. Comput. Phys. 225 (2007);
/// Celledoni, Fassò, Säfström & Zanna, "The exact computation of the free rigid body motion", SIAM
/// J. Sci. Comput. 30 (2008).

#include <cmath>
#include <variant>

#include "tumble/elliptic/complementary_theta_series.hpp"
#include "tumble/elliptic/theta_series.hpp"
#include "tumble/free_body/polhode.hpp"

namespace tumble::detail {

/// The turning of a free body whose moments differ and which does not turn about a principal axis.
class FreeAsymmetricTop {
 public:
  /// @param polhode from polhode_of(body, q, L)
  FreeAsymmetricTop(const elliptic::Polhode& polhode, const Quat& q)
      : polhode_(polhode), theta_(series_for(polhode)) {
    const double zeta = std::visit([](const auto& theta) { return theta.zeta(); }, theta_);
    const double drift = polhode_.lambda * zeta;
    rate_ = polhode_.pole_is_axis ? polhode_.G / polhode_.J[0] - drift
                                  : polhode_.G / polhode_.J[2] + drift;
    start_ = q.normalized() * turned(0).conjugate();
  }

  /// Body → world at time t [s], of any length and sign.
  Quat at(double t) const { return start_ * turned(t); }

  /// About how much the orientation at time t errs [rad] if the principal axes do by a small angle.
  ///
  /// Beside the middle axis an error grows as sinh λt does. But no farther than this: it moves
  /// G² − 2 T J₂ by the angle times how far L is from that axis, and with it k'²; and each quarter
  /// of a period, K, comes late by half of what k'² changes relatively.
  double error_by_axes(double angle, double t) const {
    const elliptic::Polhode& p = polhode_;
    const elliptic::ThetaValues v = values_at(p.u0);
    const double from_middle = std::hypot(p.amplitudes[0] * v.cn, p.amplitudes[2] * v.dn);
    const double speed = p.G / std::abs(p.lambda), u = std::abs(p.lambda * t);
    const double per_separation = std::abs(p.J[2] - p.J[0]) / p.J.prod() * speed * speed;
    const double change = angle * (from_middle + angle) * per_separation / p.modulus.kc2;
    const double quarters = 1 + u / elliptic::complete_elliptic_k(std::sqrt(p.modulus.kc2));
    const double fastest = p.amplitudes.cwiseQuotient(p.J).norm();
    return speed * fastest * std::fmin(angle * std::sinh(u), quarters * change / 2);
  }

 private:
  using Theta = std::variant<elliptic::ThetaSeries, elliptic::ComplementaryThetaSeries>;

  elliptic::ThetaValues values_at(double u) const {
    return std::visit([u](const auto& theta) { return theta(u); }, theta_);
  }

  static Theta series_for(const elliptic::Polhode& p) {
    if (p.modulus.k2 <= p.modulus.kc2) return elliptic::ThetaSeries(p.modulus, p.eta);
    return elliptic::ComplementaryThetaSeries(p.modulus, p.eta);
  }

  /// Body coordinates → coordinates with L along z.
  Quat turned(double t) const {
    const elliptic::ThetaValues v = values_at(polhode_.lambda * t + polhode_.u0);
    const Vec3& m = polhode_.amplitudes;
    const Vec3 direction(m[0] * v.cn, m[1] * v.sn, m[2] * v.dn);
    const double sign = polhode_.pole_is_axis ? 1 : -1;
    const double half = (rate_ * t + sign * v.turned) / 2;
    const double c = std::cos(half), s = std::sin(half), s2 = sign * v.sin_half;
    const Quat about_L(c * v.cos_half - s * s2, 0, 0, s * v.cos_half + c * s2);
    const Vec3 p =
        polhode_.pole_is_axis ? direction : Vec3(direction[1], direction[2], direction[0]);
    return about_L * raising(p) * polhode_.frame;
  }

  /// The turn Rx(θ) Rz(χ) that takes p to the z axis.
  /// @param p unit vector away from ±z
  static Quat raising(const Vec3& p) {
    const double r = std::sqrt(p.x() * p.x() + p.y() * p.y());
    const double cos_theta = std::sqrt((1 + p.z()) / 2), sin_theta = std::sqrt((1 - p.z()) / 2);
    const double larger = std::sqrt((1 + std::abs(p.y()) / r) / 2),
                 smaller = p.x() / (2 * r * larger);
    const double c = p.y() < 0 ? smaller : larger, s = p.y() < 0 ? larger : smaller;
    return {cos_theta * c, sin_theta * c, -sin_theta * s, cos_theta * s};
  }

  elliptic::Polhode polhode_;
  Theta theta_;
  double rate_;  ///< of the angle about L, on average [rad/s]
  Quat start_;
};

}  // namespace tumble::detail
