// Motions that break simulators: the separatrix, thin rods, fast spin, odd units, far away.
#include <doctest/doctest.h>

#include "reference/rigid_body.hpp"
#include "support/inputs.hpp"
#include "support/relative_error.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble;
using test::eps;

namespace {

PackedState<double> rk4(const RigidBody<>& body, const RigidBodyState<>& start, double duration,
                        int steps) {
  return integrate_fixed<Rk4>(RigidBodyMotion(body), pack(start), 0.0, duration, steps);
}

}  // namespace

TEST_CASE("hard case: the flip of a body near its separatrix, known to 35 digits") {
  const RigidBody<> body(1, reference::free_body.I_body);
  const RigidBodyState<> start = reference::start(reference::free_body);
  const double tolerance = 1e-15;
  const auto result =
      integrate_adaptive<Dop853>(RigidBodyMotion(body), pack(start), 0.0,
                                 reference::free_body.duration, {tolerance, tolerance});
  const RigidBodyState<> end = unpack<double>(result.y);
  // Every step may be wrong by the tolerance, and the condition number 2.7e6 stands before the end.
  const double allowed = 2.7e6 * result.steps * tolerance;
  CHECK(angle_between(end.q, reference::free_body.q_end) <= allowed);
  CHECK(end.L == start.L);
  const Vec3 omega_body = end.q.conjugate() * derived(body, end).omega;
  CHECK((omega_body - reference::free_body.omega_body_end).norm() <= allowed);
}

TEST_CASE("hard case: a rod with moments 1e6 : 1 precesses as the closed form says") {
  // A symmetric body turns by |L|/A about L and by (1/C − 1/A) L₃ about its own axis.
  const double A = 1, C = 1e-6, T = 1e-2;
  const RigidBody<> body(1, Mat3(Vec3(A, A, C).asDiagonal()));
  const RigidBodyState<> start{Vec3::Zero(), Quat(1, 0, 0, 0), Vec3::Zero(), Vec3(1, 0, 1e-3)};
  const Quat expected = exp_quaternion<double>(T / A * start.L) * start.q *
                        exp_quaternion(Vec3(0, 0, (1 / C - 1 / A) * 1e-3 * T));
  const PackedState<double> y =
      integrate_adaptive<Dop853>(RigidBodyMotion(body), pack(start), 0.0, T, {1e-13, 1e-13}).y;
  // ω is 1e-3/1e-6 = 1000 rad/s about the rod: 10 rad in all, and rounding of q enters as 1/C.
  CHECK(angle_between(unpack<double>(y).q, expected) <= 1e-9);
}

TEST_CASE("hard case: spin at 1e4 rad/s is spin at 1 rad/s in 1e-4 of the time") {
  const RigidBody<> body(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  const RigidBodyState<> slow{Vec3::Zero(), Quat(1, 0, 0, 0), Vec3::Zero(), Vec3(1, 2, 0.5)};
  RigidBodyState<> fast = slow;
  fast.L *= 1e4;
  const Quat a = unpack<double>(rk4(body, slow, 10, 1000)).q,
             b = unpack<double>(rk4(body, fast, 10e-4, 1000)).q;
  CHECK(angle_between(a, b) <= 1000 * 4 * eps);
  const PackedState<double> y =
      integrate_adaptive<Dop853>(RigidBodyMotion(body), pack(fast), 0.0, 1.0, {1e-12, 1e-12}).y;
  // 1e4 radians, each step of about a radian wrong by the tolerance in q.
  const RigidBodyState<> end = unpack<double>(y);
  CHECK(test::relative_error(kinetic_energy(body, end), kinetic_energy(body, fast)) <= 1e4 * 1e-12);
}

TEST_CASE("hard case: units do not matter, to the last bit") {
  const Mat3 I = Vec3(1, 2, 2.5).asDiagonal();
  const RigidBodyState<> start{Vec3(1, 2, 3), exp_quaternion(Vec3(1, 2, 3)), Vec3(1, 0, 2),
                               Vec3(1, 2, 0.5)};
  const PackedState<double> y = rk4(RigidBody<>(1, I), start, 10, 100);
  for (const int exponent : {-200, -60, 60, 200}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1.0, exponent);  // a power of two: exact in every product
    RigidBodyState<> scaled = start;
    scaled.P *= scale;
    scaled.L *= scale;
    const PackedState<double> z = rk4(RigidBody<>(scale, Mat3(scale * I)), scaled, 10, 100);
    CHECK(z.head<7>() == y.head<7>());
    CHECK(z.tail<6>() / scale == y.tail<6>());
  }
}

TEST_CASE("hard case: 1e8 m from the origin a body turns the same, to the last bit") {
  const RigidBody<> body(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  const RigidBodyState<> near_start{Vec3::Zero(), exp_quaternion(Vec3(1, 2, 3)), Vec3(1, 0, 2),
                                    Vec3(1, 2, 0.5)};
  RigidBodyState<> far_start = near_start;
  far_start.x = Vec3(1e8, -1e8, 1e8);
  const RigidBodyState<> here = unpack<double>(rk4(body, near_start, 10, 100));
  const RigidBodyState<> there = unpack<double>(rk4(body, far_start, 10, 100));
  CHECK(there.q.coeffs() == here.q.coeffs());
  CHECK(there.L == here.L);
  // Each of 100 steps rounds x to a multiple of 1.5e-8 m; half a unit at most, several additions.
  CHECK((there.x - far_start.x - here.x).norm() <= 100 * 4 * eps * 1e8);
}
