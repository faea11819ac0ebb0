// Short pushes whose exact effect is known, most at late times: what doubles make of moments
// counts.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/simulate/simulate.hpp"

using namespace tumble;

namespace {

using PushForce = std::function<Wrench<>(double, const RigidBody<>&, const Derived<>&)>;

/// A push along x between two moments, of one size or as sin² comes and goes.
struct Push {
  double t0, t1;  ///< of the motion [s]
  double from, to;
  double size;  ///< [N]
  bool even;

  PushForce force() const {
    return [*this](double t, const RigidBody<>&, const Derived<>&) -> Wrench<> {
      if (t < from || t >= to) return {};
      const double part = even ? 1 : std::sin(std::numbers::pi * (t - from) / (to - from));
      return {.force = Vec3(size * part * part, 0, 0)};
    };
  }
  /// The momentum that it leaves, and where the ball is at t1.
  double P() const { return size * (to - from) * (even ? 1 : 0.5); }
  double x() const { return P() * (t1 - from - (to - from) / 2); }

  /// @return true over stated error
  double dishonesty(double tolerance) const {
    const SimulationTask task{.t0 = t0, .t1 = t1, .tolerance = tolerance, .breaks = {from, to}};
    const Trajectory motion = simulate(RigidBody<>(1, Mat3::Identity()), {}, task, force());
    const RigidBodyState<> end = motion.end();
    const double error = std::max(std::abs(end.P.x() / P() - 1), std::abs(end.x.x() / x() - 1));
    return error / motion.report().error_estimate;
  }
};

/// @param pushes how many have to be answered: where doubles are too far apart, one is refused
double worst_of(int pushes, bool even) {
  test::Random rng(3);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, rng.uniform(0, 1));
  };
  double worst = 0;
  for (int i = 0, answered = 0; answered < pushes; ++i) {
    REQUIRE(i < 2 * pushes);
    const double t0 = between(1, 1e6), span = between(1e-4, 100);
    const double width = std::max(span * between(1e-6, 0.3), 16 * t0 * test::eps);
    const double from = t0 + rng.uniform(0, 1) * (span - width);
    const Push push{t0, t0 + span, from, from + width, 1 / width, even};
    try {
      worst = std::max(worst, push.dishonesty(between(1e-12, 1e-4)));
      ++answered;
    } catch (const std::runtime_error&) {  // doubles are too far apart there
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("short pushes: steps are as long as the rounded times are apart") {
  // The sum of times was rounded, the step was not: 1.2e-11 off with 1.2e-15 stated.
  CHECK(worst_of(300, true) < 10);
}

TEST_CASE("short pushes: what rounding of the moments does to a slope is in the stated error") {
  CHECK(worst_of(300, false) < 10);
}

TEST_CASE("short pushes: between breaks two runs do not go by the same steps") {
  // Then they made the same error, and 5e-14 was stated of one of 8e-9.
  test::Random rng(5);
  for (int i = 0; i < 300; ++i) {
    const double width = std::pow(10, rng.uniform(-3, -0.5)), from = rng.uniform(0, 1 - width);
    const double decay = rng.uniform(1, 9);
    const PushForce force = [&](double t, const RigidBody<>&, const Derived<>&) -> Wrench<> {
      if (t < from || t >= from + width) return {};
      return {.force = Vec3(std::exp(-decay * (t - from) / width) / width, 0, 0)};
    };
    const SimulationTask task{
        .t1 = 1, .tolerance = std::pow(10, rng.uniform(-6, -2)), .breaks = {from, from + width}};
    const Trajectory motion = simulate(RigidBody<>(1, Mat3::Identity()), {}, task, force);
    const double error = std::abs(motion.end().P.x() * decay / (1 - std::exp(-decay)) - 1);
    CHECK(error < 10 * motion.report().error_estimate);
  }
}

TEST_CASE("short pushes: what doubles cannot tell is refused, with their distance") {
  const double t0 = 5500, width = 1.6e-7;
  const auto refusal = [&](double from) {
    return test::message_of<std::runtime_error>(
        [&] { Push{t0, t0 + 0.1, from, from + width, 1e7, false}.dishonesty(1e-7); });
  };
  CHECK(test::mentions(refusal(t0 + 0.02), "9.09495e-13 s apart", "count the time from"));
  // A pulse in a piece of its own is looked at, however short the piece is in the span.
  const double late = 3e5;
  CHECK(test::mentions(test::message_of<std::runtime_error>([&] {
                         const double from = late + 1e-4;
                         Push{late, late + 2e-4, from, from + 6e-10, 1e9, false}.dishonesty(1e-9);
                       }),
                       "apart, and meanwhile the forces change by"));
}
