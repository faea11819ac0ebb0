#include "tumble/ode/midpoint.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;

TEST_CASE("midpoint_step: a worked number") {
  // y' = y² from 1 with h = 1/2: half a step to 5/4, whose slope is 25/16.
  const auto f = [](double, const test::Vector1<double>& y) -> test::Vector1<double> {
    return y.cwiseProduct(y);
  };
  const test::Vector1<double> y(1.0);
  CHECK(runge_kutta::midpoint_step(f, 0, y, 0.5)[0] == 1 + 25.0 / 32);
  CHECK(runge_kutta::Midpoint::step(f, 0, y, 0.5) == runge_kutta::midpoint_step(f, 0, y, 0.5));
}

TEST_CASE("midpoint_step: asks f at t and at t + h/2") {
  std::vector<double> times;
  const auto f = [&](double t, const Vec3& y) -> Vec3 {
    times.push_back(t);
    return -y;
  };
  runge_kutta::midpoint_step(f, 1, Vec3(Vec3::UnitX()), -0.5);
  CHECK(times == std::vector<double>{1, 0.75});
}

TEST_CASE("midpoint_step: exact where the slope is linear in t") {
  test::Random rng(22);
  for (int i = 0; i < 200; ++i) {
    const double a = rng.uniform(), b = rng.uniform(), t = rng.uniform(), h = rng.uniform();
    CAPTURE(h);
    const auto f = [&](double s, const test::Vector1<double>&) {
      return test::Vector1<double>(a + b * s);
    };
    const double exact = 0.5 + h * (a + b * (t + h / 2));
    // Numbers below 3, six roundings.
    CHECK(std::abs(runge_kutta::midpoint_step(f, t, test::Vector1<double>(0.5), h)[0] - exact) <=
          18 * test::eps);
  }
}
