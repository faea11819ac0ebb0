#include "tumble/elliptic/theta_series.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/elliptic/complementary_theta_series.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;

namespace {

/// sn, cn and dn from where they come: u as an integral of them.
template <class Series>
void check_functions(const elliptic::Modulus& m, const elliptic::Amplitude& eta) {
  const Series series(m, eta);
  const double K = elliptic::complete_elliptic_k(std::sqrt(m.kc2));
  for (const double share : {-0.99, -0.5, -1e-9, 0.0, 1e-5, 0.3, 0.7, 0.999}) {
    CAPTURE(share);
    const double u = share * (std::isinf(K) ? 20 : K);
    const elliptic::ThetaValues v = series(u);
    CHECK(std::abs(v.sn * v.sn + v.cn * v.cn - 1) < 16 * eps);
    CHECK(std::abs(v.dn * v.dn + m.k2 * v.sn * v.sn - 1) < 16 * eps);
    // F(sn) = u; where cn vanishes the integral magnifies the rounding of cn.
    const double back = v.sn * carlson_rf(v.cn * v.cn, m.kc2 + m.k2 * v.cn * v.cn, 1);
    CHECK(std::abs(back - u) <= 64 * eps * (1 + std::abs(u)) / (v.cn * v.dn));
    if (std::isinf(K)) continue;
    const elliptic::ThetaValues later = series(u + 2 * K);
    const double allowed = 32 * eps * (1 + K);
    CHECK(std::abs(later.sn + v.sn) < allowed);
    CHECK(std::abs(later.cn + v.cn) < allowed);
    CHECK(std::abs(later.dn - v.dn) < allowed);
  }
}

}  // namespace

TEST_CASE("Jacobi's functions: their identities, their integral, their period") {
  const elliptic::Amplitude eta{0.6, 0.8};
  for (const double k2 : {1e-300, 1e-20, 1e-3, 0.2, 0.5}) {
    CAPTURE(k2);
    check_functions<elliptic::ThetaSeries>({k2, 1 - k2}, eta);
    check_functions<elliptic::ComplementaryThetaSeries>({1 - k2, k2}, eta);
  }
  check_functions<elliptic::ComplementaryThetaSeries>({1, 0}, eta);
}

TEST_CASE("Jacobi's functions: both series are the same where both are good") {
  const elliptic::Modulus half{0.5, 0.5};
  for (const double angle : {0.1, 0.5, 0.9}) {
    const elliptic::Amplitude eta{std::sin(angle), std::cos(angle)};
    const elliptic::ThetaSeries a(half, eta);
    const elliptic::ComplementaryThetaSeries b(half, eta);
    for (double u = -10; u < 10; u += 0.37) {
      CAPTURE(u);
      const elliptic::ThetaValues x = a(u), y = b(u);
      CHECK(std::abs(x.sn - y.sn) < 64 * eps);
      CHECK(std::abs(x.cn - y.cn) < 64 * eps);
      CHECK(std::abs(x.dn - y.dn) < 64 * eps);
      // The arguments of Θ, each with its share of u, up to whole turns.
      const double phase_a = 2 * std::atan2(x.sin_half, x.cos_half) - a.zeta() * u;
      const double phase_b = 2 * std::atan2(y.sin_half, y.cos_half) + y.turned - b.zeta() * u;
      CHECK(std::abs(std::remainder(phase_a - phase_b, 2 * std::numbers::pi)) < 128 * eps);
    }
  }
}

TEST_CASE("Jacobi's functions: no jump half a period from two whole ones") {
  const elliptic::Amplitude eta{0.6, 0.8};
  for (const double k2 : {0.5, 0.7, 0.99, 1 - 1e-9}) {
    CAPTURE(k2);
    const elliptic::Modulus m{k2, k2 == 1 - 1e-9 ? 1e-9 : 1 - k2};
    const elliptic::ComplementaryThetaSeries series(m, eta);
    const double K = elliptic::complete_elliptic_k(std::sqrt(m.kc2));
    const auto phase = [&](const elliptic::ThetaValues& v) {
      return 2 * std::atan2(v.sin_half, v.cos_half) + v.turned;
    };
    for (int n = 0; n < 300; ++n) {
      CAPTURE(n);
      const double u = (2 * n + 1) * K;
      const elliptic::ThetaValues here = series(u), before = series(u * (1 - 1e-12));
      CHECK(here.sn == doctest::Approx(n % 2 ? -1 : 1));
      CHECK(before.sn == doctest::Approx(n % 2 ? -1 : 1));
      CHECK(std::abs(std::remainder(phase(here) - phase(before), 2 * std::numbers::pi)) < 1e-8);
    }
  }
}
