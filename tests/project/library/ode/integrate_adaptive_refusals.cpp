/// @file
/// What integrate_adaptive refuses, and where it stops.

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;
using test::contains;
using test::message_of;

namespace {

using State = test::Vector1<double>;

const auto decay = [](double, const State& y) { return State(-y[0]); };

/// "… at t = 1.25 with …" → 1.25.
double time_in(const std::string& message) {
  const std::size_t at = message.find("t = ");
  return at == std::string::npos ? std::nan("") : std::stod(message.substr(at + 4));
}

}  // namespace

TEST_CASE("integrate_adaptive: refuses a start, a time or a tolerance that is none") {
  const auto run = [](double y0, double t0, double t1, const Tolerances& tolerances) {
    return message_of<std::invalid_argument>(
        [&] { integrate_adaptive<DormandPrince54>(decay, State(y0), t0, t1, tolerances); });
  };
  const double nan = std::nan("");
  CHECK(run(1, 0, 1, {}) == "");
  CHECK(contains(run(nan, 0, 1, {}), "y0 = (nan)"));
  CHECK(contains(run(INFINITY, 0, 1, {}), "y0 = (inf)"));
  CHECK(contains(run(1, nan, 1, {}), "t0 = nan"));
  CHECK(contains(run(1, 0, -INFINITY, {}), "t1 = -inf"));
  CHECK(contains(run(1, -1e308, 1e308, {}), "t1 − t0 = inf"));
  CHECK(contains(run(1, 0, -1e-320, {}), "no digits"));
  CHECK(contains(run(1, 0, 1, {0, 1e-9}), "relative = 0"));
  CHECK(contains(run(1, 0, 1, {1e-6, -1}), "absolute = -1"));
}

TEST_CASE_TEMPLATE("integrate_adaptive: stops at once where dydt has no value", Method,
                   DormandPrince54, Dop853, Radau5) {
  const auto f = [](double, const State&) { return State(std::nan("")); };
  const std::string message =
      message_of<std::runtime_error>([&] { integrate_adaptive<Method>(f, State(1.0), 0.25, 1); });
  CHECK(contains(message, "dydt is not finite at t = 0.25 with a step of h = 0.75"));
}

TEST_CASE_TEMPLATE("integrate_adaptive: stops where the solution leaves the domain of dydt", Method,
                   DormandPrince54, Dop853, Radau5) {
  // y' = −1/√y from 1 ends at y = 0 where t = 2/3; beyond, dydt is NaN.
  const auto f = [](double, const State& y) { return State(-1 / std::sqrt(y[0])); };
  const std::string message =
      message_of<std::runtime_error>([&] { integrate_adaptive<Method>(f, State(1.0), 0, 1); });
  CAPTURE(message);
  // Near the end y ~ (1 − t/(2/3))^(2/3): with tolerances of 1e-6 it is met to 1e-5.
  CHECK(std::abs(time_in(message) - 2.0 / 3) <= 1e-5);
  CHECK(contains(message, "step"));
}

TEST_CASE_TEMPLATE("integrate_adaptive: stops at a pole, with the time of the pole", Method,
                   DormandPrince54, Dop853, Radau5) {
  // y' = y² from 1 is 1/(1 − t).
  const auto f = [](double, const State& y) { return State(y[0] * y[0]); };
  const std::string message =
      message_of<std::runtime_error>([&] { integrate_adaptive<Method>(f, State(1.0), 0, 2); });
  CAPTURE(message);
  CHECK(std::abs(time_in(message) - 1) <= 1e-5);
  CHECK(contains(message, "h = "));
  CHECK((contains(message, "singularity") || contains(message, "not finite")));
}

TEST_CASE("integrate_adaptive: stops when dydt ends between two accepted steps") {
  const auto f = [](double t, const State&) { return State(t > 0.5 ? std::nan("") : 1.0); };
  for (const double direction : {1.0, -1.0}) {
    const auto mirrored = [&](double t, const State& y) { return f(direction * t, y); };
    const std::string message = message_of<std::runtime_error>(
        [&] { integrate_adaptive<Dop853>(mirrored, State(1.0), 0, direction); });
    CAPTURE(message);
    CHECK(contains(message, "dydt is not finite"));
    CHECK(std::abs(time_in(message) - direction * 0.5) <= 1e-12);
  }
}

TEST_CASE("integrate_adaptive: gives up after a million steps, naming the stiff solver") {
  const auto f = [](double t, const State& y) { return State(-1e9 * (y[0] - std::cos(t))); };
  const std::string message = message_of<std::runtime_error>(
      [&] { integrate_adaptive<DormandPrince54>(f, State(1.0), 0, 1); });
  CHECK(contains(message, "too many steps at t = "));
  CHECK(contains(message, "Radau5"));
}

TEST_CASE("integrate_adaptive: a tolerance below rounding is said to be so") {
  const test::Kepler<double> kepler;
  const std::string message = message_of<std::runtime_error>([&] {
    integrate_adaptive<Dop853>(kepler, kepler.start(), 1e6, 1e6 + 1, Tolerances{1e-30, 1e-30});
  });
  CHECK(contains(message, "below rounding"));
}

TEST_CASE("integrate_adaptive: a span of a few units in the last place is crossed") {
  const double t0 = 1e9, t1 = std::nextafter(std::nextafter(t0, 2e9), 2e9);
  const auto solution = integrate_adaptive<DormandPrince54>(decay, State(1.0), t0, t1);
  CHECK(std::abs(solution.y[0] - std::exp(t0 - t1)) <= 4 * test::eps);
}

TEST_CASE("integrate_adaptive: a step that would not move the time is not taken") {
  // The problem asks for 1e-12 s, but the clock at 10⁹ s ticks in 1e-7 s.
  const auto fast = [](double, const State& y) { return State(-1e12 * y[0]); };
  int steps = 0;
  const std::string message = message_of<std::runtime_error>([&] {
    integrate_adaptive<Dop853>(fast, State(1.0), 1e9, 2e9, {},
                               [&](double, const State&) { ++steps; });
  });
  CHECK(contains(message, "the step became too small at t = 1000000000"));
  CHECK(steps == 0);
}
