#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "tumble/body/forces_between.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/first_event.hpp"
#include "tumble/simulate/simulate_bodies.hpp"

using namespace tumble;

namespace {

using States = std::vector<RigidBodyState<>>;

const std::vector<RigidBody<>> bodies = {RigidBody<>(2, Mat3(Vec3(1, 2, 2.5).asDiagonal())),
                                         RigidBody<>(3, Mat3(Vec3(2, 1, 1.5).asDiagonal()))};
const States starts = {{Vec3(0, 0, 1), Quat(1, 0.2, 0.3, 0.1), Vec3(1, 2, 3), Vec3(1, 2.1, 0.4)},
                       {Vec3(1, 0, 0), Quat::Identity(), Vec3(-1, 0, 2), Vec3(0.3, 0.2, 1)}};
const SpringBetween joining{0, 1, Vec3(0.1, 0.2, 0.3), Vec3(-0.2, 0, 0.1), 40, 0.5};

Vec3 momentum(const States& states) { return states[0].P + states[1].P; }
Vec3 angular_momentum_of(const States& states) {
  return states[0].L + states[0].x.cross(states[0].P) + states[1].L +
         states[1].x.cross(states[1].P);
}

/// Two balls on a line, 1 kg and 3 kg, on a spring from centre to centre: a reduced mass that
/// swings.
const std::vector<RigidBody<>> balls = {RigidBody<>(1, 0.1 * Mat3::Identity()),
                                        RigidBody<>(3, 0.2 * Mat3::Identity())};
const States pulled_apart = {{Vec3(0, 0, 0)}, {Vec3(1.5, 0, 0)}};
const SpringBetween centre_to_centre{0, 1, Vec3::Zero(), Vec3::Zero(), 12, 1};

}  // namespace

TEST_CASE("simulate: two balls on a spring swing as their reduced mass does") {
  const SceneTrajectory swing = simulate(balls, pulled_apart, {0, 10, 1e-9}, centre_to_centre);
  CHECK(swing.report().reached());
  const double omega = std::sqrt(12 / (1. * 3 / 4));
  for (const double t : {0.0, 0.7, 3.3, 9.1, 10.0}) {
    const double length = 1 + 0.5 * std::cos(omega * t);
    const States now = swing.at(t);
    CHECK(std::abs(now[0].x.x() - (1.125 - 0.75 * length)) < 1e-9 * 1.5);
    CHECK(std::abs(now[1].x.x() - (1.125 + 0.25 * length)) < 1e-9 * 1.5);
  }
}

TEST_CASE("simulate: bodies on a spring keep both momenta, and agree with the plain solver") {
  const SceneTrajectory motion = simulate(bodies, starts, {0, 5, 1e-9}, joining);
  REQUIRE(motion.report().reached());
  const States end = motion.end();
  CHECK((momentum(end) - momentum(starts)).norm() < 1e-8);
  CHECK((angular_momentum_of(end) - angular_momentum_of(starts)).norm() < 1e-7);
  States normal = starts;
  for (RigidBodyState<>& state : normal) state.q.normalize();
  const auto plain =
      integrate_adaptive<Dop853>(SceneRhs(bodies, joining), pack(normal), 0., 5., {1e-13, 1e-13});
  CHECK((pack(end) - plain.y).norm() < 1e-7);
}

TEST_CASE("simulate: the error that is stated for bodies on a spring is one") {
  const States truth = simulate(bodies, starts, {0, 5, 1e-12}, Weight{}, joining).end();
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const SceneTrajectory motion = simulate(bodies, starts, {0, 5, tolerance}, Weight{}, joining);
    CAPTURE(tolerance);
    CHECK(motion.report().reached());
    for (std::size_t i = 0; i < 2; ++i) {
      const RigidBodyState<> end = motion.end()[i];
      // The largest sizes on the way are those at the end or more.
      CHECK((end.x - truth[i].x).norm() <= motion.report().error_estimate * truth[i].x.norm());
      CHECK(angle_between(end.q, truth[i].q) <= motion.report().error_estimate);
    }
  }
}

TEST_CASE("simulate: bodies that nothing joins move as if alone, bit for bit") {
  const SceneTrajectory apart = simulate(bodies, starts, {0, 5, 1e-9}, Weight{});
  for (std::size_t i = 0; i < 2; ++i) {
    const Trajectory alone = simulate(bodies[i], starts[i], {0, 5, 1e-9}, Weight{});
    for (const double t : {0.0, 1.7, 5.0}) CHECK(pack(apart.at(t)[i]) == pack(alone.at(t)));
  }
  CHECK(apart.report().runs == 0);
  const std::vector<double> times = apart.times();
  CHECK(std::is_sorted(times.begin(), times.end()));
}

TEST_CASE("simulate: bodies on a spring, backwards in time, and their events") {
  const SceneTrajectory there = simulate(bodies, starts, {0, 5, 1e-9}, Weight{}, joining);
  const SceneTrajectory back = simulate(bodies, there.end(), {5, 0, 1e-9}, Weight{}, joining);
  CHECK((back.end()[0].x - starts[0].x).norm() < 1e-7);
  CHECK((back.end()[1].L - starts[1].L).norm() < 1e-7);
  const SceneTrajectory swing = simulate(balls, pulled_apart, {0, 1, 1e-11}, centre_to_centre);
  const auto unstretched =
      first_event(swing, [](double, const States& s) { return (s[1].x - s[0].x).norm() - 1; });
  REQUIRE(unstretched);
  CHECK(std::abs(unstretched->t - std::numbers::pi / 2 / 4) < 1e-10);
}

TEST_CASE("simulate of several bodies refuses what means nothing, and says which") {
  const auto run = [](const std::vector<RigidBody<>>& all, const States& from,
                      const SpringBetween& joint) {
    static_cast<void>(simulate(all, from, {0, 1, 1e-6}, joint));
  };
  CHECK_REFUSED(run({}, {}, joining), "there are no bodies");
  CHECK_REFUSED(run(bodies, {starts[0]}, joining), "2 bodies, but 1 states");
  States bad = starts;
  bad[1].P.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_REFUSED(run(bodies, bad, joining), "body 1: ");
  SpringBetween joint = joining;
  joint.b = 2;
  CHECK_REFUSED(run(bodies, starts, joint), "between the bodies 0 and 2: there are 2 bodies");
  joint.b = 0;
  CHECK_REFUSED(run(bodies, starts, joint), "joins body 0 to itself");
  joint = joining;
  joint.stiffness = -1;
  CHECK_REFUSED(run(bodies, starts, joint), "-1 is not a finite number ≥ 0");
}
