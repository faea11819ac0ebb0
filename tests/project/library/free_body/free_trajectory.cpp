#include "tumble/free_body/free_trajectory.hpp"

#include <doctest/doctest.h>

#include <string>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "reference/double_double_motion.hpp"
#include "reference/rigid_body.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;

namespace {

/// Moments of some body: b + c, c + a, a + b.
Vec3 moments(double a, double b, double c) { return {b + c, c + a, a + b}; }

double power_of_ten(test::Random& rng, double low, double high) {
  return std::pow(10, rng.uniform(low, high));
}

RigidBodyState<> turning(const Vec3& J, const Quat& q, const Vec3& omega_body) {
  const Vec3 L_body = J.cwiseProduct(omega_body);
  return {Vec3::Zero(), q, Vec3::Zero(), q.normalized() * L_body};
}

/// The error after a time t, in units of 1e-15 max(1, |ω| t).
double error_in_roundings(const Vec3& J, const RigidBodyState<>& start, double t) {
  const Mat3 I = J.asDiagonal();
  const reference::Turning truth{J, start.q, t < 0 ? Vec3(-start.L) : start.L};
  const auto end = reference::turned(truth, std::abs(t));  // back in time: with −L
  const double error = angle_between(FreeTrajectory(RigidBody<>(1, I), start).at(t).q, end.q);
  return error / (1e-15 * std::max(1.0, end.omega.norm() * std::abs(t)));
}

/// What the class promises, 1e-13, and what it keeps.
constexpr double kept = 5;

}  // namespace

TEST_CASE(
    "FreeTrajectory: the separatrix problem, to more digits than its condition leaves others") {
  const reference::Motion& m = reference::free_body;
  const RigidBody<> body(1, m.I_body);
  const FreeTrajectory motion(body, {Vec3::Zero(), m.q0, Vec3::Zero(), m.L_end});
  CHECK(angle_between(motion.at(m.duration).q, m.q_end) < 5e-14);
  CHECK(std::string(name_of(motion)) == "free asymmetric top (elliptic functions)");
}

TEST_CASE("FreeTrajectory: random bodies, forwards and backwards in time") {
  test::Random rng(601);
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const Vec3 J = moments(rng.uniform(0, 1), rng.uniform(0, 1), rng.uniform(0, 1));
    const Vec3 omega = rng.vector();
    const double t = power_of_ten(rng, -2, 2) / omega.norm();
    CHECK(error_in_roundings(J, turning(J, rng.rotation(), omega), i % 2 ? t : -t) < kept);
  }
}

TEST_CASE("FreeTrajectory: nearly about each axis, as close as 1e-12 and less") {
  test::Random rng(602);
  for (const int axis : {0, 1, 2})
    for (const double off : {1e-2, 1e-5, 1e-8, 1e-12, 1e-16, 1e-100}) {
      CAPTURE(axis);
      CAPTURE(off);
      const Vec3 J = moments(0.2, 0.5, 0.9);
      Vec3 omega = off * rng.vector();
      omega[axis] = 1;
      CHECK(error_in_roundings(J, turning(J, Quat(1, 0, 0, 0), omega), 40) < kept);
    }
}

TEST_CASE("FreeTrajectory: on the separatrix and next to it, on both sides") {
  test::Random rng(603);
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    const double a = rng.uniform(0.5, 1), b = rng.uniform(0.3, 0.5), c = rng.uniform(0, 0.3);
    const Vec3 J = moments(a, b, c);  // ascending
    Vec3 omega = rng.vector();
    // J₃ (J₃ − J₂) ω₃² = J₁ (J₂ − J₁) ω₁²
    omega[2] = omega[0] * std::sqrt(J[0] * (J[1] - J[0]) / (J[2] * (J[2] - J[1])));
    omega[2] *= 1 + rng.uniform(-1, 1) * power_of_ten(rng, -17, -3);
    CHECK(error_in_roundings(J, turning(J, rng.rotation(), omega), 20 / omega.norm()) < kept);
  }
}

TEST_CASE("FreeTrajectory: nearly symmetric and nearly round bodies") {
  test::Random rng(604);
  for (int i = 0; i < 48; ++i) {
    CAPTURE(i);
    const double near = power_of_ten(rng, -16, -2), axial = rng.uniform(0.1, 1.9);
    const Vec3 J = i % 3 == 0   ? Vec3(1, 1 + near, axial)
                   : i % 3 == 1 ? Vec3(axial, 1 + near, 1)
                                : Vec3(1, 1 + near, 1 - near / 3);
    const Vec3 omega = rng.vector();
    CHECK(error_in_roundings(J, turning(J, rng.rotation(), omega), 30 / omega.norm()) < kept);
  }
}

TEST_CASE("FreeTrajectory: needles, plates and moments of very different size") {
  test::Random rng(605);
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const Vec3 J =
        moments(power_of_ten(rng, -6, 0), power_of_ten(rng, -6, 0), power_of_ten(rng, -3, 0));
    const Vec3 omega = rng.vector();
    CHECK(error_in_roundings(J, turning(J, rng.rotation(), omega), 2 / omega.norm()) < kept);
  }
}

TEST_CASE("FreeTrajectory: an exact spin about each axis stays, also about the middle one") {
  const Vec3 J(1, 2, 2.5);
  const Mat3 I = J.asDiagonal();
  for (const int axis : {0, 1, 2}) {
    const Vec3 omega = 3 * Vec3::Unit(axis);
    const FreeTrajectory motion(RigidBody<>(1, I), turning(J, Quat(1, 0, 0, 0), omega));
    CHECK(std::string(name_of(motion)) == "uniform rotation");
    CHECK(angle_between(motion.at(1000).q, exp_quaternion<double>(1000 * omega)) < 1e-12);
  }
  const FreeTrajectory still(RigidBody<>(1, I), {});
  CHECK(still.at(1e9).q.coeffs() == Quat(1, 0, 0, 0).coeffs());
}

TEST_CASE("FreeTrajectory: a ball and a symmetric top need sines only") {
  test::Random rng(606);
  const Vec3 omega = rng.vector();
  for (const Vec3& J : {Vec3(1, 1, 1), Vec3(1, 1, 1.5), Vec3(0.3, 1, 1)}) {
    CHECK(std::string(name_of(FreeTrajectory(RigidBody<>(1, Mat3(J.asDiagonal())),
                                             turning(J, rng.rotation(), omega)))) !=
          "free asymmetric top (elliptic functions)");
    CHECK(error_in_roundings(J, turning(J, rng.rotation(), omega), 10) < kept);
  }
}

TEST_CASE("FreeTrajectory: axes anywhere in the body, and the path of the centre") {
  test::Random rng(607);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    const Vec3 J = moments(rng.uniform(0, 1), rng.uniform(0, 1), rng.uniform(0, 1));
    const Quat turn = rng.rotation();
    const Mat3 R = to_matrix(turn), I = R * J.asDiagonal() * R.transpose();
    const RigidBodyState<> start = turning(J, rng.rotation(), rng.vector());
    const RigidBodyState<> turned{rng.vector(), start.q * turn.conjugate(), rng.vector(), start.L};
    const RigidBodyState<> end =
        FreeTrajectory(RigidBody<>(2, Mat3((I + I.transpose()) / 2)), turned).at(3);
    const Quat truth = reference::turned({J, start.q, start.L}, 3).q * turn.conjugate();
    CHECK(angle_between(end.q, truth) < 1e-12);  // the tensor itself is rounded
    CHECK((end.x - (turned.x + 1.5 * turned.P)).norm() < 1e-15 * 10);
    CHECK(end.P == turned.P);
    CHECK(end.L == turned.L);
  }
}

TEST_CASE("FreeTrajectory: one second a million times, or a million seconds at once") {
  const Vec3 J(1, 2, 2.5);
  const Mat3 I = J.asDiagonal();
  const RigidBodyState<> start = turning(J, Quat(1, 0, 0, 0), Vec3(0.3, 0.2, 1));
  const FreeTrajectory motion(RigidBody<>(1, I), start);
  const double energy = kinetic_energy(RigidBody<>(1, I), start);
  for (const double t : {1e3, 1e5, 1e6}) {
    const RigidBodyState<> later = motion.at(t);
    CHECK(std::abs(later.q.norm() - 1) < 1e-15);
    CHECK(std::abs(kinetic_energy(RigidBody<>(1, I), later) / energy - 1) < 1e-14);
  }
  const RigidBodyState<> middle = motion.at(5e5);
  const Quat two_halves = FreeTrajectory(RigidBody<>(1, I), middle).at(5e5).q;
  CHECK(angle_between(motion.at(1e6).q, two_halves) < 1e-13 * 1e6);
}

TEST_CASE("FreeTrajectory: refuses what is no motion") {
  const RigidBody<> body(1, Mat3::Identity());
  RigidBodyState<> bad;
  bad.q = Quat(0, 0, 0, 0);
  CHECK_REFUSED(FreeTrajectory(body, bad), "quaternion", "zero");
  bad = {};
  bad.L.y() = NAN;
  CHECK_REFUSED(FreeTrajectory(body, bad), "not finite", "nan");
}
