#include "tumble/ode/integrate_fixed.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;
using test::contains;
using test::message_of;

TEST_CASE("integrate_fixed: a worked number") {
  // Two Euler steps of 1/2 for y' = y: 1 → 3/2 → 9/4.
  const auto f = [](double, const test::Vector1<double>& y) { return y; };
  CHECK(integrate_fixed<runge_kutta::Euler>(f, test::Vector1<double>(1.0), 0, 1, 2)[0] == 2.25);
}

TEST_CASE("integrate_fixed: the times are t0 + i h, and the last is t1 itself") {
  const auto f = [](double, const Vec3& y) { return y; };
  for (int steps = 1; steps <= 100; ++steps) {
    CAPTURE(steps);
    std::vector<double> times;
    integrate_fixed<runge_kutta::Midpoint>(f, Vec3(Vec3::Zero()), 0.1, 0.7, steps,
                                           [&](double t, const Vec3&) { times.push_back(t); });
    REQUIRE(static_cast<int>(times.size()) == steps);
    const double h = (0.7 - 0.1) / steps;
    for (int i = 1; i < steps; ++i) CHECK(times[static_cast<std::size_t>(i - 1)] == 0.1 + i * h);
    CHECK(times.back() == 0.7);  // where t0 + steps · h may be a neighbour
  }
}

TEST_CASE("integrate_fixed: a million steps do not let the time drift") {
  double latest = 0;
  const auto f = [](double, const test::Vector1<double>& y) { return y; };
  integrate_fixed<runge_kutta::Euler>(f, test::Vector1<double>(0.0), 0, 100'000, 1'000'000,
                                      [&](double t, const test::Vector1<double>&) {
                                        if (t < 99'999.95) latest = t;
                                      });
  // One product and one sum: added up, the steps of 0.1 would be off by 1e-4.
  CHECK(std::abs(latest - 99'999.9) <= 2 * test::eps * 1e5);
}

TEST_CASE("integrate_fixed: back again with the same steps") {
  const test::Kepler<double> kepler;
  const test::Vector4<double> y0 = kepler.start();
  const test::Vector4<double> y1 = integrate_fixed<Rk4>(kepler, y0, 0, 1, 1000);
  // Twice the error of one way, C h⁴ with C about 20 here (measured: 1.7e-12).
  CHECK((integrate_fixed<Rk4>(kepler, y1, 1, 0, 1000) - y0).norm() <= 2 * 20 * std::pow(1e-3, 4));
}

TEST_CASE("integrate_fixed: refuses what is no integration") {
  const auto f = [](double, const Vec3& y) { return y; };
  const Vec3 y0(1, 2, 3);
  const double nan = std::nan("");
  const auto run = [&](const Vec3& y, double t0, double t1, int steps) {
    return message_of<std::invalid_argument>([&] { integrate_fixed<Rk4>(f, y, t0, t1, steps); });
  };
  CHECK(contains(run(y0, 0, 1, 0), "steps = 0"));
  CHECK(contains(run(y0, 0, 1, -3), "steps = -3"));
  CHECK(contains(run(y0, nan, 1, 1), "t0 = nan"));
  CHECK(contains(run(y0, 0, INFINITY, 1), "t1 = inf"));
  CHECK(contains(run(Vec3(1, nan, 3), 0, 1, 1), "y0 = (  1 nan   3)"));
  CHECK(run(y0, 0, 0, 1) == "");
  CHECK(contains(run(y0, -1e308, 1e308, 10), "t1 − t0 = inf"));
  CHECK(contains(run(y0, 0, 1e-320, 1), "no digits"));
  CHECK(contains(run(y0, 0, 1e-300, 1'000'000'000), "take fewer"));
}

TEST_CASE("integrate_fixed: no time is no step, with implicit methods too") {
  const auto f = [](double, const Vec3& y) -> Vec3 { return -y; };
  const Vec3 y0(1, 2, 3);
  CHECK(integrate_fixed<Radau5>(f, y0, 1, 1, 3) == y0);
  CHECK(integrate_fixed<runge_kutta::BackwardEuler>(f, y0, 1, 1, 3) == y0);
  CHECK(integrate_fixed<Rk4>(f, y0, 1, 1, 3) == y0);
}
