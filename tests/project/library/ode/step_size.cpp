#include "tumble/ode/step_size.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;
using namespace tumble::detail;

TEST_CASE("adaptive_step_size: a worked number") {
  // An error 32 times too large of order 4: half the step, and 0.9 of that for safety.
  CHECK(std::abs(runge_kutta::adaptive_step_size(1.0, 32.0, 4) - 0.45) <= 4 * test::eps);
}

TEST_CASE("adaptive_step_size: the proposed step has 0.9^(q+1) of the allowed error") {
  test::Random rng(51);
  for (int i = 0; i < 200; ++i) {
    const int q = 1 + i % 8;
    const double h = rng.uniform(-2, 2), error = std::exp(rng.uniform(-1, 1));
    CAPTURE(q);
    CAPTURE(error);
    const double ratio = runge_kutta::adaptive_step_size(h, error, q) / h;
    CHECK(std::abs(error * std::pow(ratio, q + 1) - std::pow(0.9, q + 1)) <= 20 * q * test::eps);
  }
}

TEST_CASE("adaptive_step_size: changes by no more than to a fifth and tenfold") {
  CHECK(runge_kutta::adaptive_step_size(1.0, 1e30, 4) == 0.2);
  CHECK(runge_kutta::adaptive_step_size(1.0, INFINITY, 4) == 0.2);
  CHECK(runge_kutta::adaptive_step_size(1.0, std::nan(""), 4) == 0.2);
  CHECK(runge_kutta::adaptive_step_size(-1.0, 1e-30, 4) == -10);
  CHECK(runge_kutta::adaptive_step_size(1.0f, 0.0f, 4) == 10);
}

TEST_CASE("initial_step_size: from the sizes of y' and y'', in the direction of time") {
  using State = test::Vector1<double>;
  const Tolerances tolerances;
  const double allowed = tolerances.absolute + tolerances.relative;
  for (const double rate : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
    CAPTURE(rate);
    const auto f = [&](double, const State& y) { return State(-rate * y[0]); };
    const State y0(1.0), dydt0(-rate);
    // h⁵ max(|y'|, |y''|) = 1 % of what is allowed, but at most |y/y'|.
    const double derivative = std::max(rate, rate * rate) / allowed;
    const double expected = std::min(1 / rate, std::pow(0.01 / derivative, 0.2));
    const double forwards = initial_step_size(f, 0, y0, dydt0, 1e10, 4, tolerances);
    // y'' is a difference of numbers that agree to 1 %.
    CHECK(std::abs(forwards - expected) <= 400 * test::eps * expected);
    CHECK(initial_step_size(f, 0, y0, dydt0, -1e10, 4, tolerances) < 0);
    CHECK(initial_step_size(f, 0, y0, dydt0, 1e-12, 4, tolerances) <= 1e-12);
  }
}

TEST_CASE("initial_step_size: finite where the state rests and where f soon has no value") {
  using State = test::Vector1<double>;
  const auto rest = [](double, const State&) { return State(0.0); };
  const double h = initial_step_size(rest, 0, State(0.0), State(0.0), 10, 4, {});
  CHECK(h > 0);
  CHECK(h <= 10);
  const auto root = [](double, const State& y) { return State(-std::sqrt(y[0])); };
  const auto edge = [](double t, const State&) { return State(t > 0 ? std::nan("") : 1.0); };
  CHECK(initial_step_size(root, 0, State(1.0), State(-1.0), 10, 4, {}) > 0);
  CHECK(initial_step_size(edge, 0, State(1.0), State(1.0), 10, 4, {}) > 0);
  const auto pole = [](double t, const State&) { return State(t > 0 ? INFINITY : 1.0); };
  CHECK(initial_step_size(pole, 0, State(1.0), State(1.0), 10, 4, {}) > 0);
}
