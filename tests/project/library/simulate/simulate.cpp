#include "tumble/simulate/simulate.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "reference/rigid_body.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble;

namespace {

const RigidBody<> full(2, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
const RigidBody<> top(2, Mat3(Vec3(1, 1, 0.5).asDiagonal()));
const RigidBody<> ball(2, Mat3(Vec3(1, 1, 1).asDiagonal()));

RigidBodyState<> moving() {
  return {Vec3(1, 2, 3), Quat(1, 2, 3, 4).normalized(), Vec3(2, 0, 4), Vec3(0.3, 1, -0.5)};
}

/// The same scene by the full equation of motion.
template <class... Forces>
RigidBodyState<> by_the_full_model(const RigidBody<>& body, double t1, const Forces&... forces) {
  const RigidBodyRhs motion(body, forces...);
  const auto solution = integrate_adaptive<Dop853>(motion, pack(moving()), 0.0, t1, {1e-13, 1e-13});
  return unpack<double>(solution.y);
}

void check_same(const RigidBodyState<>& a, const RigidBodyState<>& b, double allowed) {
  CHECK(angle_between(a.q, b.q) < allowed);
  CHECK((a.x - b.x).norm() < allowed * std::max(1.0, b.x.norm()));
  CHECK((a.P - b.P).norm() < allowed * std::max(1.0, b.P.norm()));
  CHECK((a.L - b.L).norm() < allowed * std::max(1.0, b.L.norm()));
}

const ForceAtBodyPoint pull{Vec3(0, 1, -5), Vec3(0.1, 0, 1)};

}  // namespace

TEST_CASE("simulate: the lowest rung of the ladder gives what the full model gives") {
  const SimulationTask task{0, 5, 1e-9};
  const BodyDrag drag{0.4, 0};
  for (const auto& [body, model] :
       {std::pair{ball, Model::ball}, {top, Model::symmetric_top}, {full, Model::full_body}}) {
    const Trajectory found = simulate(body, moving(), task, Weight{}, drag);
    CHECK(found.report().model == model);
    CHECK(found.report().runs == 0);  // nothing was integrated
    CHECK(found.report().reached());
    check_same(found.end(), by_the_full_model(body, 5, Weight{}, drag), 1e-11);
  }
}

TEST_CASE("simulate: a particle where nobody asks for the turning, also if there is a torque") {
  const BodyDrag drag{0.4, 0.1};
  const Trajectory found =
      simulate(full, moving(), {0, 5, 1e-9, Wanted::path_only}, Weight{}, pull, drag);
  CHECK(found.report().model == Model::particle);
  CHECK(found.report().runs == 0);
  const RigidBodyState<> truth = by_the_full_model(full, 5, Weight{}, pull, drag);
  CHECK((found.end().x - truth.x).norm() < 1e-11 * truth.x.norm());
  CHECK((found.end().P - truth.P).norm() < 1e-11 * truth.P.norm());
}

TEST_CASE("simulate: torques in one, two and three directions, and drag of the turning") {
  const ForceAtBodyPoint second{Vec3(1, 0, 0.5), Vec3(0, 0.3, 0.2)},
      third{Vec3(0, 2, 1), Vec3(0.4, 0.3, 0)}, fourth{Vec3(1, 1, 1), Vec3(-1, 0.3, 0.7)};
  const BodyDrag drag{0.4, 0.2};
  const SimulationTask task{0, 5, 1e-10};
  check_same(simulate(full, moving(), task, pull).end(), by_the_full_model(full, 5, pull), 1e-9);
  check_same(simulate(full, moving(), task, pull, pull, Weight{}).end(),
             by_the_full_model(full, 5, pull, pull, Weight{}), 1e-9);
  check_same(simulate(full, moving(), task, drag).end(), by_the_full_model(full, 5, drag), 1e-9);
  check_same(simulate(full, moving(), task, pull, second).end(),
             by_the_full_model(full, 5, pull, second), 1e-9);
  check_same(simulate(full, moving(), task, pull, second, third, fourth, drag).end(),
             by_the_full_model(full, 5, pull, second, third, fourth, drag), 1e-9);
}

TEST_CASE("simulate: axes anywhere in the body") {
  test::Random rng(7);
  const Mat3 R = to_matrix(rng.rotation()), I = R * Vec3(1, 2, 2.5).asDiagonal() * R.transpose();
  const RigidBody<> body(2, Mat3((I + I.transpose()) / 2));
  check_same(simulate(body, moving(), {0, 5, 1e-10}, pull).end(), by_the_full_model(body, 5, pull),
             1e-9);
}

TEST_CASE("simulate: the top, at every tolerance, as a steady force and as any force") {
  const reference::Motion& m = reference::top;
  const RigidBody<> body(1, m.I_body);
  const RigidBodyState<> start{Vec3::Zero(), m.q0, Vec3::Zero(),
                               m.q0 * Vec3(m.I_body * m.omega_body0)};
  const ForceAtBodyPoint weight{Vec3(0, 0, -5), Vec3(0, 0, 1)};
  const auto any = [&](double t, const RigidBody<>& b, const Derived<>& now) -> Wrench<> {
    return weight(t, b, now);
  };
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-11}) {
    CAPTURE(tolerance);
    const Trajectory steady = simulate(body, start, {0, m.duration, tolerance}, weight);
    CHECK(steady.report().reached());
    CHECK(angle_between(steady.end().q, m.q_end) < tolerance);
    if (tolerance >= 1e-9) CHECK(steady.report().runs == 0);  // Lagrange's closed form
    const Trajectory general = simulate(body, start, {0, m.duration, tolerance}, any);
    CHECK(general.report().reached());
    CHECK(angle_between(general.end().q, m.q_end) < tolerance);
    CHECK(general.report().evaluations > steady.report().evaluations);
  }
}

TEST_CASE("simulate: between the steps it is as exact as at the end") {
  const Trajectory rough = simulate(full, moving(), {0, 5, 1e-8}, pull);
  for (const double t : {0.0, 0.01, 1.234, 3.3, 4.999, 5.0}) {
    CAPTURE(t);
    const RigidBodyState<> truth = t == 0 ? moving() : by_the_full_model(full, t, pull);
    check_same(rough.at(t), truth, 1e-7);
  }
  CHECK_REFUSED(rough.at(5.1), "5.1", "not in");
}

TEST_CASE("simulate: an end that is missed by rounding is that end, forwards and backwards") {
  const double end = 0.3;  // three tenths of it, 0.1 * 3, is above it
  for (const double sign : {1., -1.}) {
    const Trajectory motion = simulate(full, moving(), {0, sign * end, 1e-8}, Weight{});
    REQUIRE(0.1 * 3 > end);
    CHECK(motion.at(sign * (0.1 * 3)).x == motion.end().x);
    CHECK(motion.at(-sign * 1e-17).x == moving().x);
    CHECK_REFUSED(motion.at(sign * (end + 0x1p-30)), "not in", "outside by 9.31323e-10");
  }
  CHECK_REFUSED(simulate(full, moving(), {0, end, 1e-8}).at(std::nan("")), "nan", "not in");
}

TEST_CASE("simulate: an unreachable tolerance is said") {
  const Trajectory found = simulate(full, moving(), {0, 500, 1e-16}, pull);
  CHECK_FALSE(found.report().reached());
  CHECK(found.report().error_estimate > 1e-16);
  CHECK_FALSE(simulate(full, moving(), {0, 1e6, 1e-12}).report().reached());
}

TEST_CASE("simulate: starts at any time, and no time at all is the start") {
  const RigidBodyState<> late = simulate(full, moving(), {100, 105, 1e-9}, pull).end();
  check_same(late, simulate(full, moving(), {0, 5, 1e-9}, pull).end(), 1e-8);
  check_same(simulate(full, moving(), {3, 3, 1e-9}, pull).end(), moving(), 1e-15);
}

TEST_CASE("simulate: refuses what it cannot do, and says what") {
  CHECK_REFUSED(simulate(full, moving(), {0, INFINITY, 1e-6}), "t0 = 0", "t1 = inf");
  CHECK_REFUSED(simulate(full, moving(), {0, NAN, 1e-6}), "nan");
  CHECK_REFUSED(simulate(full, moving(), {-1e308, 1e308, 1e-6}), "inf s");
  CHECK_REFUSED(simulate(full, moving(), {0, 1e-320, 1e-6}), "no digits");
  CHECK_REFUSED(simulate(full, moving(), {0, 1, 0}), "tolerance", "0");
  RigidBodyState<> bad = moving();
  bad.x[1] = INFINITY;
  CHECK_REFUSED(simulate(full, bad, {0, 1, 1e-6}), "not finite");
  bad = moving();
  bad.q = Quat(0, 0, 0, 0);
  CHECK_REFUSED(simulate(full, bad, {0, 1, 1e-6}), "quaternion");
  CHECK_REFUSED(simulate(full, moving(), {0, 1, 1e-6}, BodyDrag{-1, 0}), "drag", "-1");
  CHECK_REFUSED(
      simulate(full, moving(), {0, 1, 1e-6}, SpringToWorld{Vec3(0, 0, 0), Vec3(1, 2, 3), 1e60, 1}),
      "the stiffness 1e+60 N/m", "for 1 s", "N/m at most");
  CHECK_REFUSED(simulate(full, moving(), {0, 1, 1e-6},
                         SpringToWorld{Vec3(0, 0, 0), Vec3(1, 2, 3), 1, 1, 1e60}),
                "the damping 1e+60 N s/m");
  const auto poison = [](double, const RigidBody<>&, const Derived<>&) -> Wrench<> {
    return {Vec3::Constant(NAN), Vec3::Zero()};
  };
  CHECK(test::message_of<std::runtime_error>([&] {
          simulate(full, moving(), {0, 1, 1e-6}, poison);
        }).find("not finite") != std::string::npos);
}
