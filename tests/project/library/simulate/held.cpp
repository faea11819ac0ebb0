#include "tumble/simulate/held.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/extended_trajectory.hpp"
#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "reference/double_double_motion.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/first_event.hpp"

using namespace tumble;

namespace {

constexpr double g = 9.80665;

/// A rod of length 1 m that is held at one end, its other end `angle` away from straight down.
struct Pendulum {
  RigidBody<> rod{2, Mat3(Vec3(2. / 12, 2. / 12, 1e-3).asDiagonal())};
  HeldBody held{rod, Vec3(0, 0, 0.5)};
  RigidBodyState<> start;

  explicit Pendulum(double angle)
      : start(held.state(Vec3(0, 0, 3), exp_quaternion<double>(Vec3(angle, 0, 0)), Vec3::Zero())) {}
  double tensor() const { return held.about_point().I_body()(0, 0); }
  double energy(const RigidBodyState<>& s) const {
    return kinetic_energy(rod, s) + rod.mass() * g * s.x.z();
  }
};

}  // namespace

TEST_CASE("HeldBody: a state is that of the centre of mass, and comes back from its turning") {
  test::Random rng(811);
  for (int i = 0; i < 100; ++i) {
    const Mat3 axes = rng.rotation().toRotationMatrix();
    const Vec3 moments(rng.uniform(1, 1.4), rng.uniform(1, 1.4), rng.uniform(1, 1.4));
    const RigidBody<> body(rng.uniform(0.1, 10), axes * moments.asDiagonal() * axes.transpose());
    const HeldBody held(body, rng.vector());
    const Vec3 point = rng.vector();
    const RigidBodyState<> state = held.state(point, rng.rotation(), rng.vector());
    const RigidBodyState<> turning = held.turning_of(state);
    CHECK((turning.x - point).norm() < 1e-14);
    CHECK(turning.P.isZero(0));
    // About the point: L of the centre, and that of its motion round the point.
    CHECK((turning.L - (state.L + (state.x - point).cross(state.P))).norm() <
          1e-14 * (1 + turning.L.norm()));
    CHECK((pack(held.state_of(turning)) - pack(state)).norm() < 1e-13 * (1 + pack(state).norm()));
  }
}

TEST_CASE("simulate a held body: the swing of a rod takes as long as the elliptic integral says") {
  for (const double angle : {0.1, 1., 2.5}) {
    const Pendulum pendulum(angle);
    // T = 4 √(I/(m g d)) K(sin ½angle)
    const double period =
        4 * std::sqrt(pendulum.tensor() / (2 * g * 0.5)) * std::comp_ellint_1(std::sin(angle / 2));
    const Trajectory swing =
        simulate(pendulum.held, pendulum.start, {.t1 = period, .tolerance = 1e-11}, Weight{});
    CHECK(swing.report().reached());
    CHECK(angle_between(swing.end().q, pendulum.start.q) < 1e-9);
    CHECK(angle_between(swing.at(period / 2).q, exp_quaternion<double>(Vec3(-angle, 0, 0))) < 1e-9);
    for (const double t : {0.1 * period, 0.3 * period}) {
      const RigidBodyState<> s = swing.at(t);
      CHECK((s.x - Vec3(0, 0, 3)).norm() == doctest::Approx(0.5).epsilon(1e-14));
      CHECK(std::abs(pendulum.energy(s) - pendulum.energy(pendulum.start)) < 1e-9);
    }
  }
}

TEST_CASE("simulate a held body: a spinning top on its tip has a closed form, and the right one") {
  test::Random rng(812);
  int closed = 0;
  for (int i = 0; i < 20; ++i) {
    const double A = rng.uniform(0.2, 2), C = A * rng.uniform(0.1, 1.9),
                 height = rng.uniform(0.1, 1);
    const RigidBody<> body(1.5, Mat3(Vec3(A, A, C).asDiagonal()));
    const HeldBody top(body, Vec3(0, 0, -height));
    const Quat q = rng.rotation();
    const Vec3 omega = rng.vector() + rng.uniform(5, 30) * (q * Vec3::UnitZ());
    const RigidBodyState<> start = top.state(Vec3::Zero(), q, omega);
    const Trajectory motion = simulate(top, start, {.t1 = 3, .tolerance = 1e-10}, Weight{});
    closed += motion.report().runs == 0;
    const Vec3 J(A + 1.5 * height * height, A + 1.5 * height * height, C);
    const auto truth = reference::turned(
        {J, q, top.turning_of(start).L, Vec3(0, 0, -1.5 * g), Vec3(0, 0, height)}, 3);
    CHECK(angle_between(motion.end().q, truth.q) < 1e-10);
    CHECK((motion.end().x - truth.q * Vec3(0, 0, height)).norm() < 1e-10);
  }
  CHECK(closed >= 15);  // one whose axis passes next to the vertical is followed by series
}

TEST_CASE("simulate a held body: drag on the centre and a spring turn it as their torques say") {
  const Pendulum pendulum(1);
  const BodyDrag drag{0.3, 0};
  const SpringToWorld spring{Vec3(0, 0, -0.5), Vec3(0, 1, 2), 4, 0.2, 0.1};
  const Trajectory motion = simulate(pendulum.held, pendulum.start, {.t1 = 2, .tolerance = 1e-11},
                                     Weight{}, drag, spring);
  CHECK(motion.report().reached());
  // In the plane: I φ̈ = torque, by RK4 with steps so short that nothing of them is left.
  const double I = pendulum.tensor();
  const auto acceleration = [&](double angle, double rate) {
    const Vec3 down(0, std::sin(angle), -std::cos(angle)),
        ahead(0, std::cos(angle), std::sin(angle));
    const Vec3 end = Vec3(0, 0, 3) + down, l = spring.anchor - end;
    const double length = l.norm(), growth = -(rate * ahead).dot(l) / length;
    const Vec3 pull = (4 * (length - 0.2) + 0.1 * growth) / length * l;
    return (-2 * g * 0.5 * std::sin(angle) - 0.3 * 0.25 * rate + pull.dot(ahead)) / I;
  };
  double angle = 1, rate = 0;
  const int steps = 20000;
  const double h = 2. / steps;
  for (int i = 0; i < steps; ++i) {
    const double k1 = acceleration(angle, rate), r2 = rate + h / 2 * k1;
    const double k2 = acceleration(angle + h / 2 * rate, r2), r3 = rate + h / 2 * k2;
    const double k3 = acceleration(angle + h / 2 * r2, r3), r4 = rate + h * k3;
    const double k4 = acceleration(angle + h * r3, r4);
    angle += h / 6 * (rate + 2 * r2 + 2 * r3 + r4);
    rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  CHECK(angle_between(motion.end().q, exp_quaternion<double>(Vec3(angle, 0, 0))) < 1e-8);
  const Trajectory damped = simulate(pendulum.held, pendulum.start, {.t1 = 2}, Weight{}, drag);
  CHECK(pendulum.energy(damped.end()) < pendulum.energy(pendulum.start) - 0.1);
}

TEST_CASE("simulate a held body: a point that moves, or is none, is refused") {
  Pendulum pendulum(1);
  pendulum.start.P = Vec3(1, 0, 0);
  CHECK_REFUSED(simulate(pendulum.held, pendulum.start, {}, Weight{}), "held body", "moves");
  CHECK_REFUSED(HeldBody(pendulum.rod, Vec3(NAN, 0, 0)), "held body", "not finite");
  pendulum = Pendulum(1);
  pendulum.start.q.coeffs().setZero();
  CHECK_REFUSED(simulate(pendulum.held, pendulum.start, {}, Weight{}), "the quaternion is zero");
  pendulum.start.q.coeffs().setConstant(NAN);
  CHECK_REFUSED(simulate(pendulum.held, pendulum.start, {}, Weight{}), "the state", "not finite");
}

TEST_CASE("simulate a held body: the quaternion may have any length") {
  const RigidBody<> body(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  const HeldBody held(body, Vec3(0.1, 0.2, 0.3));
  const Quat q = exp_quaternion<double>(Vec3(1, 0.3, 0.2));
  const Vec3 omega(0.3, 1, 2);
  const RigidBodyState<> start = held.state(Vec3::Zero(), q, omega);
  const RigidBodyState<> right = simulate(held, start, {}, Weight{}).end();
  for (const double length : {1e-300, 1e-160, 1e155, 1e300}) {
    CAPTURE(length);
    const Quat long_q(Eigen::Vector4d(length * q.coeffs()));
    const RigidBodyState<> from = held.state(Vec3::Zero(), long_q, omega);
    CHECK((from.x - start.x).norm() <= 1e-15);
    CHECK((from.L - start.L).norm() <= 1e-14);
    CHECK(angle_between(simulate(held, from, {}, Weight{}).end().q, right.q) <= 1e-14);
  }
}

TEST_CASE("simulate a held body: a needle in turned axes, held beside its axis, says its error") {
  test::Random rng(813);
  for (int i = 0; i < 40; ++i) {
    const double thin = std::pow(10, rng.uniform(-9, -4));
    const Mat3 axes = to_matrix(rng.rotation());
    const Mat3 I =
        axes * Vec3(thin, 1 + thin * rng.uniform(-0.9, 0.9), 1).asDiagonal() * axes.transpose();
    const RigidBody<> needle(1, Mat3((I + I.transpose()) / 2));
    const HeldBody held(needle, 0.3 * rng.vector());
    const Quat q = rng.rotation();
    const Vec3 omega = axes * Vec3(rng.uniform(3, 10), rng.uniform(-0.01, 0.01), 0);
    const RigidBodyState<> start = held.state(Vec3::Zero(), q, q * omega);
    // ω of these very numbers, with more digits; and from there on nothing of the library's.
    const auto [R, moments] = test::exact_axes(needle.I_body());
    const Vector3<test::DD> L = test::into_body(q, start.L);
    test::LongVec spin = test::LongVec::Zero();
    for (int k = 0; k < 3; ++k) {
      const test::DD along = R(0, k) * L[0] + R(1, k) * L[1] + R(2, k) * L[2];
      for (int c = 0; c < 3; ++c) spin[c] += test::as_long(R(c, k) * (along / moments[k]));
    }
    test::MotionScene scene{};
    scene.mass = 1;
    scene.I_body = held.about_point().I_body();
    scene.t1 = 10;
    scene.start = {Vec3::Zero(), q, Vec3::Zero(),
                   q * Vec3((scene.I_body.cast<test::Long>() * spin).cast<double>())};
    test::ExtendedTrajectory truth(scene);
    REQUIRE(truth.advance_to(10));
    const Trajectory found = simulate(held, start, {.t1 = 10, .tolerance = 1e-12});
    const double error = angle_between(found.end().q, Quat(truth.state().q.cast<double>()));
    CAPTURE(thin);
    CHECK(error <= 2 * found.report().error_estimate);
  }
}

// Of a fast top L is nearly all spin, which does not move the centre: an error that is small beside
// L may be large beside P.
TEST_CASE("simulate a held body: the stated error is that of P and of L about the centre, too") {
  test::Random rng(814);
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const double axial = rng.uniform(0.2, 1.9), height = std::pow(10, rng.uniform(-1, 0.5));
    const HeldBody held(RigidBody<>(1, Mat3(Vec3(1, 1, axial).asDiagonal())), Vec3(0, 0, -height));
    const double rate = std::pow(10, rng.uniform(0, 1.5));  // at which it would fall over [rad/s]
    const Vec3 weight(0, 0, -rate * rate * (1 + height * height) / height);
    const Quat q = exp_quaternion<double>(std::pow(10, rng.uniform(-6, -2)) * rng.vector());
    const Vec3 spin(0, 0, rate * std::pow(10, rng.uniform(-1, 2)));
    const Vec3 omega = q * spin + rate * std::pow(10, rng.uniform(-4, -1)) * rng.vector();
    const RigidBodyState<> start = held.state(Vec3::Zero(), q, omega);
    const double tolerance = std::pow(10, rng.uniform(-9, -4));
    const Trajectory found =
        simulate(held, start, {.t1 = 1, .tolerance = tolerance}, SteadyForces{.force = weight});

    test::MotionScene scene{};
    scene.mass = 1;
    scene.I_body = held.about_point().I_body();
    scene.t1 = 1;
    scene.start = held.turning_of(start);
    scene.steady.at_point = {{weight, Vec3(0, 0, height)}};
    test::ExtendedTrajectory truth(scene);
    double P_off = 0, L_off = 0, P_size = 0, L_size = 0;
    for (int k = 1; k <= 20; ++k) {
      REQUIRE(truth.advance_to(k / 20.L));
      const test::LongState turned = truth.state();
      const RigidBodyState<> right = held.state_of(
          {Vec3::Zero(), Quat(turned.q.cast<double>()), Vec3::Zero(), turned.L.cast<double>()});
      const RigidBodyState<> there = found.at(k / 20.);
      P_size = std::max(P_size, right.P.norm());
      L_size = std::max(L_size, right.L.norm());
      P_off = std::max(P_off, (there.P - right.P).norm());
      L_off = std::max(L_off, (there.L - right.L).norm());
    }
    const double error = std::max(P_off / P_size, L_off / L_size);
    CHECK(error <= 10 * found.report().error_estimate);
    if (found.report().reached()) CHECK(error <= tolerance);
  }
}

// Its closed form errs in its phases: P is as wrong as q, and no finer turning is looked for.
TEST_CASE("simulate a held body: a top keeps its closed form, whose error is that of P, too") {
  const HeldBody held(RigidBody<>(0.05, Mat3(Vec3(2e-5, 2e-5, 1.35e-5).asDiagonal())),
                      Vec3(0, 0, 0.0375));
  const Quat q = exp_quaternion<double>(Vec3(2.84, 0, 0));
  const RigidBodyState<> start = held.state(Vec3::Zero(), q, Vec3(0, 89.1, 286.5));
  const Trajectory top = simulate(held, start, {.t1 = 3, .tolerance = 1e-9}, Weight{});
  CHECK(top.report().runs == 0);
  CHECK(top.report().reached());
  const Trajectory fine = simulate(held, start, {.t1 = 3, .tolerance = 1e-12}, Weight{});
  REQUIRE(fine.report().runs > 0);
  for (const double t : {0.5, 1.5, 3.})
    CHECK((top.at(t).P - fine.at(t).P).norm() <= top.report().error_estimate * fine.at(t).P.norm());
}
