#pragma once
/// @file
/// Jacobi's elliptic functions for k² ≥ ½ up to 1 itself, where the period becomes infinite: theta
/// functions after Jacobi's imaginary transformation, sums of pulses one period apart. The nome is
/// q' = exp(−π K/K') ≤ 0.043; at k = 1 only sech and tanh are left.
///
/// Source: Whittaker & Watson, "A Course of Modern Analysis" (4th ed. 1927), §21.51 and §22.4; NIST
/// Digital Library of Mathematical Functions, §20.7(viii) and §22.6(iv).

#include <array>
#include <cmath>
#include <numbers>

#include "tumble/elliptic/theta_series.hpp"

namespace tumble::elliptic {

/// @addtogroup elliptic
/// @{

/// sn, cn, dn of any u and arg Θ(u + iη) for one modulus and one η, as ThetaSeries gives them.
class ComplementaryThetaSeries {
 public:
  /// @param m   k² ≥ ½
  /// @param eta amplitude of η for the complementary modulus, 0 ≤ η < K'
  ComplementaryThetaSeries(const Modulus& m, const Amplitude& eta)
      : K_(complete_elliptic_k(std::sqrt(m.kc2))), Kc_(complete_elliptic_k(std::sqrt(m.k2))) {
    const double pi = std::numbers::pi, q = std::exp(-pi * K_ / Kc_);
    const double q2 = q * q, q4 = q2 * q2, q9 = q4 * q4 * q;
    powers_ = {1, q, q4, q9};
    const double theta3 = 1 + 2 * (q + q4 + q9), theta4 = 1 - 2 * (q - q4 + q9);
    root_k_ = theta4 / theta3;
    dn_factor_ = (1 + q2 * (1 + q4)) / theta3;

    const double sn2 = eta.sn * eta.sn, cn2 = eta.cn * eta.cn, dn2 = cn2 + m.k2 * sn2;
    const double x = pi / 2 * (eta.sn * detail::carlson_rf(cn2, dn2, 1) / Kc_);
    for (std::size_t n = 0; n < 4; ++n) {
      const double multiple = static_cast<double>(2 * n + 1) * x;
      cos_[n] = std::cos(multiple);
      sin_[n] = std::sin(multiple);
    }
    period_turn_ = 2 * x;
    double theta = 1, slope = 0;
    for (std::size_t n = 1; n < 4; ++n) {
      const double signed_power = n % 2 ? -powers_[n] : powers_[n], i = static_cast<double>(n);
      theta += 2 * signed_power * std::cos(2 * i * x);
      slope -= 4 * i * signed_power * std::sin(2 * i * x);
    }
    zeta_ = eta.sn * std::sqrt(dn2) / eta.cn - pi / (2 * Kc_) * slope / theta;
  }

  /// What the argument of Θ grows with u beside what `turned` of the values says [rad].
  double zeta() const { return zeta_; }

  /// @param u any real number
  ThetaValues operator()(double u) const {
    const double rest = std::isinf(K_) ? u : std::remainder(u, 2 * K_), a = std::abs(rest);
    // From the rest, so that both round alike where u is half a period from two whole ones.
    const double periods = std::isinf(K_) ? 0 : std::nearbyint((u - rest) / (2 * K_));
    const double e = std::exp(-std::numbers::pi / Kc_ * a);  // e^(−2y), y = π |u| / 2K'
    const double g = std::isinf(K_) ? 0 : std::exp(-std::numbers::pi / Kc_ * (K_ - a));
    const double sign = std::fmod(periods, 2) == 0 ? 1 : -1;

    // Sums of sinh and cosh of (2n + 1) y, and over e^y / 2.
    double sinh_sum = 0, cosh_sum = 0, re = 0, im = 0, e_odd = e, weight = 1;
    for (std::size_t n = 0; n < 4; ++n) {
      const double w = powers_[n] * weight;
      sinh_sum += (n % 2 ? -w : w) * (1 - e_odd);
      cosh_sum += w * (1 + e_odd);
      re += w * cos_[n] * (1 + e_odd);
      im += w * sin_[n] * (1 - e_odd);
      e_odd *= e * e;
      weight *= g;
    }
    const double q2 = powers_[1] * powers_[1], q6 = q2 * q2 * q2, e2 = e * e, g2 = g * g;
    const double first = g * (1 + e2), second = q2 * g2 * (1 + e2 * e2),
                 third = q6 * g2 * g * (1 + e2 * e2 * e2);
    const double pulse = 2 * std::sqrt(e) * dn_factor_ / cosh_sum;
    ThetaValues v{sign * std::copysign(sinh_sum / (root_k_ * cosh_sum), rest),
                  sign * pulse / root_k_ * (1 - first + second - third),
                  pulse * (1 + first + second + third),
                  1,
                  0,
                  periods * period_turn_};
    detail::halve_direction(re, std::copysign(im, rest), v);
    return v;
  }

 private:
  double K_, Kc_, zeta_;
  double root_k_, dn_factor_, period_turn_;
  std::array<double, 4> powers_, cos_, sin_;  ///< q'^(n²), cos and sin of (2n + 1) π η / 2K'
};

/// @}

}  // namespace tumble::elliptic
