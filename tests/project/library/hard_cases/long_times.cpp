// A million seconds at once.
#include <doctest/doctest.h>

#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/simulate/simulate.hpp"
#include "turning.hpp"

using namespace tumble;

TEST_CASE(
    "long times: after 1e6 s, and after 1e9 s, the error is what rounding of the angle makes") {
  const Vec3 J(1, 2, 3);
  for (const Vec3& omega : {Vec3(0.5, 1, 0.7), Vec3(1e-3, 2, 1e-3), Vec3(0.01, 0.02, 3)}) {
    CAPTURE(omega.transpose());
    const RigidBodyState<> start = test::turning(J, omega);
    const reference::LongFreeTurning truth = test::truth_of(J, start);
    const FreeTrajectory motion(test::body_with(J), start);
    for (const double t : {1e6, 1e9})
      CHECK(angle_between(motion.at(t).q, truth.at(t).q) <= 5e-15 * omega.norm() * t);
  }
}

TEST_CASE("long times: simulate() says which tolerance the digits of t leave") {
  const Vec3 J(1, 2, 3);
  const RigidBodyState<> start = test::turning(J, Vec3(0.5, 1, 0.7));
  const Quat truth = test::truth_of(J, start).at(1e6).q;
  for (const double tolerance : {1e-6, 1e-12}) {
    const Trajectory motion = simulate(test::body_with(J), start, {0, 1e6, tolerance});
    CHECK(motion.report().reached() == (tolerance > 1e-7));
    CHECK(angle_between(motion.end().q, truth) <= motion.report().error_estimate);
  }
}
