#include "tumble/steady/lagrange_top.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "reference/double_double_motion.hpp"
#include "reference/rigid_body.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

steady::SteadyTorque torque_on(const Vec3& J, const Vec3& force, const Vec3& p) {
  const RigidBody<> body(1, Mat3(J.asDiagonal()));
  return steady::SteadyTorque(body, steady_forces(body, ForceAtBodyPoint{force, p}));
}

/// The error after t, in units of what is promised; of the orientation and of L.
double error_in_bounds(const Vec3& J, const Vec3& force, const Vec3& p, const Quat& q,
                       const Vec3& L, double t) {
  const auto top = steady::LagrangeTop::from(torque_on(J, force, p), q, L);
  REQUIRE(top);
  const auto truth = reference::turned({J, q, L, force, p}, t);
  const Vec3 L_truth = truth.q * Vec3(J.cwiseProduct(truth.omega));
  const steady::LagrangeTop::State found = top->at(t);
  const double error = std::max(angle_between(found.q, truth.q),
                                (found.L - L_truth).norm() / std::max(L.norm(), L_truth.norm()));
  return error / top->error_bound(t);
}

}  // namespace

TEST_CASE("LagrangeTop: the top of the reference, to fourteen digits") {
  const reference::Motion& m = reference::top;
  const Vec3 J = m.I_body.diagonal();
  const Vec3 L = m.q0 * Vec3(J.cwiseProduct(m.omega_body0));
  const auto top = steady::LagrangeTop::from(torque_on(J, Vec3(0, 0, -5), Vec3(0, 0, 1)), m.q0, L);
  REQUIRE(top);
  CHECK(angle_between(top->at(m.duration).q, m.q_end) < 1e-13);
  CHECK((top->at(m.duration).L - m.L_end).norm() < 1e-12);
}

TEST_CASE("LagrangeTop: random tops, slow and fast, long and flat, any axis, any direction") {
  test::Random rng(701);
  int found = 0;
  for (int i = 0; i < 150; ++i) {
    CAPTURE(i);
    const int axis = i % 3;
    const double A = rng.uniform(0.2, 2);
    Vec3 J = Vec3::Constant(A);
    J[axis] = 2 * A * rng.uniform(0.05, 1);
    const Vec3 force = 5 * rng.vector(), p = rng.uniform() * Vec3::Unit(axis);
    const Quat q = rng.rotation();
    const Vec3 L = std::pow(10, rng.uniform(-2, 2)) * rng.vector();
    if (!steady::LagrangeTop::from(torque_on(J, force, p), q, L)) continue;
    ++found;
    const double t = rng.uniform(0, 3) + (i % 10 == 0 ? 10 : 0);
    CHECK(error_in_bounds(J, force, p, q, L, t) < 1);
  }
  CHECK(found > 120);
}

TEST_CASE("LagrangeTop: regular precession, with hardly any nutation or none") {
  // C ω₃ φ̇ − A φ̇² cos θ = μ holds θ where it is.
  const double A = 1, C = 0.5, mu = 3, theta = 0.7, precession = 0.4;
  const double spin = (mu + A * precession * precession * std::cos(theta)) / (C * precession);
  const Quat q = exp_quaternion<double>(Vec3(theta, 0, 0));
  for (const double off : {0.0, 1e-14, 1e-10, 1e-6, 1e-3}) {
    CAPTURE(off);
    const Vec3 L_body(off, A * precession * std::sin(theta), C * spin);
    CHECK(error_in_bounds(Vec3(A, A, C), Vec3(0, 0, -mu), Vec3(0, 0, 1), q, q * L_body, 5) < 1);
  }
}

TEST_CASE("LagrangeTop: too slow to sleep, it falls from as near to upright as doubles tell") {
  const Vec3 J(1, 1, 0.5), down(0, 0, -5), p(0, 0, 1);
  const double critical = std::sqrt(4 * J[0] * 5) / J[2];
  for (const double part : {0.99, 0.9, 0.5, 0.1})
    for (const double tilt : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
      CAPTURE(part);
      CAPTURE(tilt);
      const Quat q(std::cos(tilt / 2), std::sin(tilt / 2), 0, 0);
      const Vec3 L = q * Vec3(0, 0, J[2] * part * critical);
      CHECK(error_in_bounds(J, down, p, q, L, 10) < 1);
      // Upright a second time: for 1e-12 the truth itself would need more digits.
      if (tilt >= 1e-9) CHECK(error_in_bounds(J, down, p, q, L, 40) < 1);
    }
}

TEST_CASE("LagrangeTop: is none without an axis, a torque about it, or off the axis") {
  const Vec3 down(0, 0, -5), L(1, 2, 3);
  const Quat q = exp_quaternion<double>(Vec3(0.4, 0, 0));
  CHECK_FALSE(steady::LagrangeTop::from(torque_on({1, 1.1, 0.5}, down, Vec3(0, 0, 1)), q, L));
  CHECK_FALSE(steady::LagrangeTop::from(torque_on({1, 1, 0.5}, down, Vec3(0.1, 0, 1)), q, L));
  CHECK_FALSE(steady::LagrangeTop::from(torque_on({1, 1, 1}, down, Vec3(0, 0, 1)), q, L));
  CHECK_FALSE(steady::LagrangeTop::from(torque_on({1, 1, 0.5}, down, Vec3(0, 0, 0)), q, L));
  CHECK(steady::LagrangeTop::from(torque_on({1, 1, 0.5}, down, Vec3(0, 0, 1)), q, L));
  // Asleep: upright and spinning about the vertical.
  for (const double L3 : {0.0, 1.0, 5.0, 9.0, 50.0})
    CHECK_FALSE(steady::LagrangeTop::from(torque_on({1, 1, 0.5}, down, Vec3(0, 0, 1)),
                                          Quat(1, 0, 0, 0), Vec3(0, 0, L3)));
}
