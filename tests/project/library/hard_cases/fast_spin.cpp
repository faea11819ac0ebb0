// 1e4 rad/s: a gyroscope, a turbine.
#include <doctest/doctest.h>

#include "project/harness/relative_error.hpp"
#include "tumble/ensemble/advance.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/simulate/simulate.hpp"
#include "turning.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("fast spin: 1e4 rad/s is 1 rad/s in 1e-4 of the time") {
  const Vec3 J(1, 2, 2.5);
  const RigidBodyRhs motion(test::body_with(J));
  const RigidBodyState<> slow = test::turning(J, Vec3(1, 1, 0.2));
  RigidBodyState<> fast = slow;
  fast.L *= 1e4;
  const auto end = [&](const RigidBodyState<>& start, double duration) {
    return unpack<double>(integrate_fixed<Rk4>(motion, pack(start), 0.0, duration, 1000)).q;
  };
  CHECK(angle_between(end(slow, 10), end(fast, 10e-4)) <= 1000 * 4 * eps);
  const PackedState<double> y =
      integrate_adaptive<Dop853>(motion, pack(fast), 0.0, 1.0, {1e-12, 1e-12}).y;
  // 1e4 radians, each step of about a radian wrong by the tolerance in q.
  CHECK(test::relative_error(kinetic_energy(motion.body(), unpack<double>(y)),
                             kinetic_energy(motion.body(), fast)) <= 1e4 * 1e-12);
}

TEST_CASE("fast spin: after 1e4 and 1e6 radians the closed form is where it should be") {
  const Vec3 J(1, 2, 3);
  for (const Vec3& omega : {Vec3(5e3, 7e3, 5e3), Vec3(1e4, 1, 1), Vec3(1, 1e4, 1)}) {
    CAPTURE(omega.transpose());
    const RigidBodyState<> start = test::turning(J, omega);
    const reference::LongFreeTurning truth = test::truth_of(J, start);
    for (const double t : {1.0, 100.0}) {
      const Trajectory motion = simulate(test::body_with(J), start, {0, t, 1e-6});
      CHECK(motion.report().reached());
      CHECK(angle_between(motion.end().q, truth.at(t).q) <= 1e-14 * omega.norm() * t);
    }
  }
}

TEST_CASE("fast spin: a torque on it, as a steady force and as any force") {
  const Vec3 J(1, 2, 3);
  const RigidBody<> body = test::body_with(J);
  const RigidBodyState<> start = test::turning(J, Vec3(1e4, 1e3, 1e3));
  const ForceAtBodyPoint pull{Vec3(0, 0, -500), Vec3(0.6, 0, 0.8)};
  const auto any = [&](double t, const RigidBody<>& b, const Derived<>& now) -> Wrench<> {
    return pull(t, b, now);
  };
  const double t = 0.05, tolerance = 1e-9;
  const Quat truth = reference::turned({J, start.q, start.L, pull.force, pull.p_body}, t).q;
  const Trajectory steady = simulate(body, start, {0, t, tolerance}, pull),
                   general = simulate(body, start, {0, t, tolerance}, any);
  CHECK(steady.report().reached());
  CHECK(general.report().reached());
  CHECK(angle_between(steady.end().q, truth) <= tolerance);
  CHECK(angle_between(general.end().q, truth) <= tolerance);
}

TEST_CASE("fast spin: an ensemble with steps of a tenth of a radian") {
  const Vec3 J(1, 2, 3);
  const std::vector<RigidBody<>> bodies{test::body_with(J)};
  const std::vector<RigidBodyState<>> states{test::turning(J, Vec3(5e3, 7e3, 5e3))};
  Ensemble ensemble(bodies, states);
  CHECK(advance<TaylorMagnus<8>>(ensemble, {1e-5, 100'000}).count == 0);
  const Quat truth = test::truth_of(J, states.front()).at(1).q;
  // 1e5 steps; the step itself, 1e-5 s, is rounded once.
  CHECK(angle_between(ensemble.state(0).q, truth) <= 1e5 * 1e4 * eps);
}
