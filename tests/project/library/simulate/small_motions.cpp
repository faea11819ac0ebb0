// Motions that are small beside the body: what error they have themselves is said.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tumble/simulate/simulate.hpp"

using namespace tumble;

namespace {

using AnyForce = std::function<Wrench<>(double, const RigidBody<>&, const Derived<>&)>;

/// Held at the origin by a spring of 100 N/m, and pushed.
Trajectory on_a_spring(double x, double push, double tolerance) {
  const AnyForce force = [push](double, const RigidBody<>&, const Derived<>& now) {
    return Wrench<>{.force = Vec3(push, 0, 0) - 100 * now.x};
  };
  RigidBodyState<> start;
  start.x = Vec3(x, 0, 0);
  return simulate(RigidBody<>(1, Mat3::Identity()), start, {.t1 = 10, .tolerance = tolerance},
                  force);
}

}  // namespace

TEST_CASE("small motions: what error they have as a part of themselves is said, and is true") {
  for (const double tolerance : {1e-4, 1e-9, 1e-12})
    for (const double x : {1e-4, 1e-6, 1e-9, 1e-12}) {
      CAPTURE(tolerance);
      CAPTURE(x);
      const Trajectory motion = on_a_spring(x, 0, tolerance);
      const SimulationReport& report = motion.report();
      CHECK(report.reached());
      const double error = std::abs(motion.end().x.x() / x - std::cos(100.));
      CHECK(error <= std::max(report.error_estimate, report.error_of_small_motion));
      if (x < 1e-5) CHECK(report.error_of_small_motion > report.error_estimate);
    }
}

TEST_CASE("small motions: a motion that is large enough has no error of its own") {
  CHECK(on_a_spring(1, 0, 1e-9).report().error_of_small_motion == 0);
}

TEST_CASE("small motions: a body that forces hold at rest is done, though they are rounded") {
  const SimulationReport report = on_a_spring(0.0981, 9.81, 1e-9).report();
  CHECK(report.reached());
  CHECK(report.steps < 1000);
}
