// A body next to its separatrix turns over and over: how often, and when each time.
#include <doctest/doctest.h>

#include "reference/rigid_body.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/simulate/first_event.hpp"
#include "tumble/simulate/simulate.hpp"
#include "turning.hpp"

using namespace tumble;

namespace {

constexpr double duration = 1000;

/// Spin about the middle axis: its sign is the way the body is up.
double middle_spin(double, const RigidBodyState<>& s) { return (s.q.conjugate() * s.L).y(); }

}  // namespace

TEST_CASE("flips: the truth by periods is the truth by steps") {
  const Vec3 J(1, 2, 3);
  const RigidBodyState<> start = test::turning(J, Vec3(1e-3, 2, 1e-3));
  const reference::LongFreeTurning truth = test::truth_of(J, start);
  CHECK(truth.defect() < 1e-26);
  const reference::TurningEnd steps = reference::turned({J, start.q, start.L}, 90),
                              periods = truth.at(90);
  CHECK(angle_between(steps.q, periods.q) < 1e-15);
  CHECK((steps.omega - periods.omega).norm() < 1e-15);
  for (const double t : truth.flips(8, 90))
    CHECK(std::abs(reference::turned({J, start.q, start.L}, t).omega[1]) < 1e-13);
}

TEST_CASE("flips: simulate() finds each of them in 1000 s, and when") {
  const Vec3 J(1, 2, 3);
  // Nearer to the axis the truth itself would need more digits.
  for (const double tilt : {0.1, 1e-3, 1e-6, 1e-9}) {
    CAPTURE(tilt);
    const RigidBodyState<> start = test::turning(J, Vec3(tilt, 2, tilt));
    const reference::LongFreeTurning truth = test::truth_of(J, start);
    const Trajectory motion = simulate(test::body_with(J), start, {0, duration, 1e-10});
    REQUIRE(motion.report().reached());
    const std::vector<Event> flips = every_event(motion, middle_spin);
    REQUIRE(!flips.empty());
    const std::vector<double> times = truth.flips(flips.front().t, duration);
    REQUIRE(flips.size() == times.size());
    double worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
      worst = std::max(worst, std::abs(flips[i].t - times[i]));
    CHECK(worst < 1e-14 * 2 * duration);  // what the closed form promises, at 2 rad/s
    const auto once = first_event(motion, middle_spin);
    REQUIRE(once);
    CHECK(once->t == flips.front().t);
  }
}

TEST_CASE("flips: exactly about the middle axis there is none") {
  const Vec3 J(1, 2, 3);
  const RigidBodyState<> start = test::turning(J, Vec3(0, 2, 0));
  const Trajectory motion = simulate(test::body_with(J), start, {0, duration, 1e-11});
  CHECK(every_event(motion, middle_spin).empty());
}

TEST_CASE("flips: steps of order 8 pass the first ones, with what the condition number leaves") {
  const RigidBody<> body(1, reference::free_body.I_body);
  const RigidBodyState<> start = reference::start(reference::free_body);
  const double tolerance = 1e-15;
  const auto result = integrate_adaptive<Dop853>(
      RigidBodyRhs(body), pack(start), 0.0, reference::free_body.duration, {tolerance, tolerance});
  const RigidBodyState<> end = unpack<double>(result.y);
  // Every step may be wrong by the tolerance, and the condition number 2.7e6 stands before the end.
  const double allowed = 2.7e6 * result.steps * tolerance;
  CHECK(angle_between(end.q, reference::free_body.q_end) <= allowed);
  CHECK(end.L == start.L);
  const Vec3 omega_body = end.q.conjugate() * derived(body, end).omega;
  CHECK((omega_body - reference::free_body.omega_body_end).norm() <= allowed);
}
