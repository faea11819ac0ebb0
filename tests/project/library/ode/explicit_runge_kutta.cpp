#include "tumble/ode/explicit_runge_kutta.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

struct ClassicalTableau {
  static constexpr std::size_t stages = 4;
  static constexpr int order = 4;
  static constexpr runge_kutta::Weights<4> c = {0, 0.5L, 0.5L, 1};
  static constexpr std::array<runge_kutta::Weights<4>, 4> a = {{{}, {0.5L}, {0, 0.5L}, {0, 0, 1}}};
  static constexpr runge_kutta::Weights<4> b = {1 / 6.L, 1 / 3.L, 1 / 3.L, 1 / 6.L};
};

}  // namespace

TEST_CASE("ExplicitRungeKutta: with Kutta's tableau it is rk4_step") {
  const test::Kepler<double> kepler;
  test::Random rng(61);
  for (int i = 0; i < 200; ++i) {
    const test::Vector4<double> y(1 + rng.uniform(0, 1), rng.uniform(), rng.uniform(),
                                  rng.uniform());
    CAPTURE(y.transpose());
    const double h = rng.uniform(-0.1, 0.1);
    // The same sums in another order; h times a dozen roundings of numbers of the size of y.
    CHECK((runge_kutta::ExplicitRungeKutta<ClassicalTableau>::step(kepler, 0, y, h) -
           runge_kutta::rk4_step(kepler, 0, y, h))
              .norm() <= 12 * test::eps * y.norm());
  }
}

TEST_CASE("ExplicitRungeKutta: asks f once a stage, at t + c h") {
  std::vector<double> times;
  const auto f = [&](double t, const Vec3& y) -> Vec3 {
    times.push_back(t);
    return -y;
  };
  DormandPrince54::step(f, 1, Vec3(Vec3::UnitX()), 0.5);
  REQUIRE(times.size() == 6);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(times[i] == 1 + static_cast<double>(DormandPrince54Tableau::c[i]) * 0.5);
  times.clear();
  Dop853::step(f, 1, Vec3(Vec3::UnitX()), 0.5);
  CHECK(times.size() == 12);
}

TEST_CASE("ExplicitRungeKutta: one step of y' = y is the Taylor polynomial, then something else") {
  // Of order 5 with 6 stages: e^h − y1 = O(h⁶), for DormandPrince54 h⁶ (1/720 − 1/600).
  const auto f = [](long double, const test::Vector1<long double>& y) { return y; };
  const long double h = 0.125L;
  const long double y1 = DormandPrince54::step(f, 0, test::Vector1<long double>(1.0L), h)[0];
  const long double polynomial =
      1 + h * (1 + h / 2 * (1 + h / 3 * (1 + h / 4 * (1 + h / 5 * (1 + h * 5 / 600 * 120 / 5)))));
  CHECK(std::abs(static_cast<double>(y1 - polynomial)) <= 8 * test::eps);
}
