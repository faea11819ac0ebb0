#include "tumble/ode/rk4.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;

TEST_CASE("rk4_step: a worked number") {
  // y' = y with h = 1 gives the Taylor polynomial 1 + 1 + 1/2 + 1/6 + 1/24 = 65/24.
  const auto f = [](double, const test::Vector1<double>& y) { return y; };
  const test::Vector1<double> y(1.0);
  CHECK(std::abs(runge_kutta::rk4_step(f, 0, y, 1.0)[0] - 65.0 / 24) <= 8 * test::eps);
  CHECK(Rk4::step(f, 0, y, 0.5) == runge_kutta::rk4_step(f, 0, y, 0.5));
}

TEST_CASE("rk4_step: asks f at t, twice in the middle, and at the end") {
  std::vector<double> times;
  const auto f = [&](double t, const Vec3& y) -> Vec3 {
    times.push_back(t);
    return -y;
  };
  runge_kutta::rk4_step(f, 1, Vec3(Vec3::UnitX()), 0.5);
  CHECK(times == std::vector<double>{1, 1.25, 1.25, 1.5});
}

TEST_CASE("rk4_step: Simpson's rule, exact for slopes cubic in t") {
  test::Random rng(23);
  for (int i = 0; i < 200; ++i) {
    const double a = rng.uniform(), b = rng.uniform(), t = rng.uniform(), h = rng.uniform();
    CAPTURE(t);
    CAPTURE(h);
    const auto f = [&](double s, const test::Vector1<double>&) {
      return test::Vector1<double>(a * s * s * s + b);
    };
    const double exact = 2 + a * (std::pow(t + h, 4) - std::pow(t, 4)) / 4 + b * h;
    // Numbers below 20, about a dozen roundings.
    CHECK(std::abs(runge_kutta::rk4_step(f, t, test::Vector1<double>(2.0), h)[0] - exact) <=
          240 * test::eps);
  }
}
