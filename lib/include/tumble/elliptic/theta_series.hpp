#pragma once
/// @file
/// Jacobi's elliptic functions for k² ≤ ½ by theta functions: trigonometric sums whose terms fall
/// like q^(n²), with a nome q ≤ e^(−π) = 0.043. Three terms are enough.
///
///     Θ(u) = θ₄(z, q),  z = π u / 2K,  q = exp(−π K'/K)
///
/// Source: Whittaker & Watson, "A Course of Modern Analysis" (4th ed. 1927), ch. 21 and §22.3;
/// NIST Digital Library of Mathematical Functions, §20.2 and §22.2.

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "tumble/elliptic/integrals.hpp"
#include "tumble/elliptic/modulus.hpp"

namespace tumble::detail {

/// The direction of a complex number to the right of 0, halved: cos and sin of ½ atan(im/re).
inline void halve_direction(double re, double im, elliptic::ThetaValues& values) {
  const double cosine = re / std::sqrt(re * re + im * im);
  values.cos_half = std::sqrt((1 + cosine) / 2);
  values.sin_half = im / re * cosine / (2 * values.cos_half);
}

}  // namespace tumble::detail

namespace tumble::elliptic {

/// @addtogroup elliptic
/// @{

/// sn, cn, dn of any u and arg Θ(u + iη) for one modulus and one η.
class ThetaSeries {
 public:
  /// @param m   k² ≤ ½
  /// @param eta amplitude of η for the complementary modulus, 0 ≤ η < K'
  ThetaSeries(const Modulus& m, const Amplitude& eta) : K_(complete_elliptic_k(std::sqrt(m.kc2))) {
    const double pi = std::numbers::pi, Kc = complete_elliptic_k(std::sqrt(m.k2));
    const double sn2 = eta.sn * eta.sn, cn2 = eta.cn * eta.cn, dn2 = cn2 + m.k2 * sn2;
    q_ = std::exp(-pi * Kc / K_);
    // q e^(2y), y = π η / 2K, from K' − η: q and e^(2y) by themselves may leave the range.
    const double up = std::exp(-pi / K_ * eta.cn * detail::carlson_rf(m.k2 * sn2, m.k2, dn2));
    const double down = q_ * std::exp(-pi / K_ * eta.sn * detail::carlson_rf(cn2, dn2, 1));
    double power = 1;  // q^(n² − n)
    double up_n = 1, down_n = 1, theta = 1, slope = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int n = static_cast<int>(i) + 1, sign = n % 2 ? -1 : 1;
      up_n *= up;
      down_n *= down;
      even_[i] = sign * power * (up_n + down_n);
      odd_[i] = -sign * power * (up_n - down_n);
      theta += even_[i];
      slope += n * odd_[i];
      power *= std::pow(q_, 2 * n);
    }
    zeta_ = pi / K_ * slope / theta;
    const double q4 = q_ * q_ * q_ * q_;
    const double theta3 = 1 + 2 * q_ * (1 + q_ * q_ * q_ * (1 + q4 * q_));
    const double theta4 = 1 - 2 * q_ * (1 - q_ * q_ * q_ * (1 - q4 * q_));
    const double theta2 = 1 + q_ * q_ * (1 + q4);  // without 2 q^(1/4)
    sn_factor_ = theta3 / theta2;
    cn_factor_ = theta4 / theta2;
    dn_factor_ = theta4 / theta3;
  }

  /// Z(iη)/i, what the argument of Θ grows with u on average [rad].
  double zeta() const { return zeta_; }

  /// @param u any real number
  ThetaValues operator()(double u) const {
    const double z = std::numbers::pi / 2 * (std::remainder(u, 4 * K_) / K_);
    const double s = std::sin(z), c = std::cos(z);
    const double c2 = (c - s) * (c + s), s2 = 2 * s * c;          // of 2z
    const double c4 = (c2 - s2) * (c2 + s2), s4 = 2 * s2 * c2;    // of 4z
    const double c6 = c4 * c2 - s4 * s2, s6 = s4 * c2 + c4 * s2;  // of 6z
    const double q2 = q_ * q_, q3 = q2 * q_, q5 = q3 * q2;
    const double s3 = s2 * c + c2 * s, c3 = c2 * c - s2 * s, s5 = s4 * c + c4 * s,
                 c5 = c4 * c - s4 * s;
    const double theta1 = s - q2 * (s3 - q2 * q2 * s5), theta2 = c + q2 * (c3 + q2 * q2 * c5);
    const double theta3 = 1 + 2 * q_ * (c2 + q3 * (c4 + q5 * c6)),
                 theta4 = 1 - 2 * q_ * (c2 - q3 * (c4 - q5 * c6));
    ThetaValues v{sn_factor_ * theta1 / theta4,
                  cn_factor_ * theta2 / theta4,
                  dn_factor_ * theta3 / theta4,
                  1,
                  0,
                  0};
    detail::halve_direction(1 + even_[0] * c2 + even_[1] * c4 + even_[2] * c6,
                            odd_[0] * s2 + odd_[1] * s4 + odd_[2] * s6, v);
    return v;
  }

 private:
  double K_, q_, zeta_;
  double sn_factor_, cn_factor_, dn_factor_;
  std::array<double, 3> even_, odd_;  ///< of cos 2nz and sin 2nz in Θ(u + iη)
};

/// @}

}  // namespace tumble::elliptic
