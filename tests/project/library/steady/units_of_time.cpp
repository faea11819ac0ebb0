/// @file
/// A body that is slower or faster by a factor moves the same, by a clock that is.
#include <doctest/doctest.h>

#include "tumble/body.hpp"
#include "tumble/simulate.hpp"

using namespace tumble;

namespace {

/// Twenty radians of a lopsided body under a force on one of its points, with `second` for a
/// second.
Trajectory motion(double second, double tolerance) {
  const RigidBody<> body(1, Mat3(Vec3(1, 1.5, 2).asDiagonal()));
  RigidBodyState<> start;
  start.L = Vec3(0.3, 1, 0.2) / second;
  SteadyForces forces;
  forces.at_point = {{Vec3(0, 0, -1) / (second * second), Vec3(0.3, 0.5, 1)}};
  forces.angular_drag = 0.02 / second;
  return simulate(body, start, {.t1 = 20 * second, .tolerance = tolerance}, forces);
}

}  // namespace

TEST_CASE("steady forces: by any unit of time, from 1e-14 s to 1e30 s, the motion is the same") {
  for (const double tolerance : {1e-4, 1e-9, 1e-12}) {
    const auto known = motion(1, tolerance);
    for (const double second : {1e-14, 1e-9, 1e-6, 1e-3, 1e6, 1e9, 1e12, 1e20, 1e30}) {
      CAPTURE(tolerance);
      CAPTURE(second);
      const auto same = motion(second, tolerance);
      CHECK(same.report().reached());
      const double stated = same.report().error_estimate + known.report().error_estimate;
      CHECK(same.end().q.angularDistance(known.end().q) <= stated);
      CHECK(same.at(7 * second).q.angularDistance(known.at(7).q) <= stated);
    }
  }
}
