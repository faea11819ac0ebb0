#include "tumble/ode/observed_order.hpp"

#include <doctest/doctest.h>

#include <array>

#include "problems.hpp"

using namespace tumble;
using test::contains;
using test::message_of;

TEST_CASE("observed_order: a worked number") {
  // The error falls to a quarter when the step is halved.
  CHECK(std::abs(runge_kutta::observed_order(std::array{1.0, 0.5}, std::array{0.04, 0.01}) - 2) <=
        8 * test::eps);
}

TEST_CASE("observed_order: finds p in C h^p, whatever C and the order of the points") {
  test::Random rng(31);
  for (int i = 0; i < 200; ++i) {
    const double p = rng.uniform(-3, 9), C = std::exp(rng.uniform(-5, 5));
    CAPTURE(p);
    CAPTURE(C);
    std::vector<double> h, errors;
    for (int k = 0; k < 5; ++k) {
      h.push_back(std::exp(rng.uniform(-4, 0)));
      errors.push_back(C * std::pow(h.back(), p));
    }
    const auto [low, high] = std::minmax_element(h.begin(), h.end());
    // Logarithms below 45, rounded a few times, divided by the width of the data.
    CHECK(std::abs(runge_kutta::observed_order(h, errors) - p) <=
          10 * 45 * 8 * test::eps / std::log(*high / *low));
  }
}

TEST_CASE("observed_order: scatter is averaged") {
  // Errors h² too large and too small by the same factor at both ends and right in the middle.
  const std::vector<double> h{1, 0.5, 0.25}, errors{2, 0.25, 2 * 0.0625};
  CHECK(std::abs(runge_kutta::observed_order(h, errors) - 2) <= 8 * test::eps);
}

TEST_CASE("observed_order: refuses what has no slope") {
  using List = std::vector<double>;
  const auto run = [](const List& h, const List& errors) {
    return message_of<std::invalid_argument>([&] { runge_kutta::observed_order(h, errors); });
  };
  CHECK(contains(run({1}, {1}), "1 points make no line"));
  CHECK(contains(run({}, {}), "0 points make no line"));
  CHECK(contains(run({1, 2}, {1}), "2 steps but 1 errors"));
  CHECK(contains(run({1, -0.5}, {1, 1}), "step 1 is -0.5"));
  CHECK(contains(run({1, 0.5}, {1, 0}), "error 1 is 0"));
  CHECK(contains(run({1, 0.5}, {std::nan(""), 1}), "error 0 is nan"));
  CHECK(contains(run({std::nan(""), 0.5}, {1, 1}), "step 0 is nan"));
  CHECK(contains(run({0.5, 0.5}, {1, 2}), "all steps are 0.5"));
}
