// Moments of very different size, moments that hardly differ, and tensors that no body has.
#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/simulate/simulate.hpp"
#include "turning.hpp"

using namespace tumble;
using test::eps;

namespace {

/// The error of simulate() after t, in radians.
double error_after(const Vec3& J, const RigidBodyState<>& start, double t) {
  const Trajectory motion = simulate(test::body_with(J), start, {0, t, 1e-9});
  CHECK(motion.report().reached());
  return angle_between(motion.end().q, reference::turned({J, start.q, start.L}, t).q);
}

}  // namespace

TEST_CASE("inertia: needles with moments 1 : 1e12, about any axis") {
  for (const double ratio : {1e-3, 1e-6, 1e-9, 1e-12})
    for (const Vec3& omega : {Vec3(1, 0.02, 0.01), Vec3(0.3, 0.2, 1), Vec3(0.01, 1, 0.01)})
      for (const Vec3& J : {Vec3(ratio, 1, 1 + ratio / 2), Vec3(ratio, 1, 1)}) {
        CAPTURE(ratio);
        CAPTURE(omega.transpose());
        CHECK(error_after(J, test::turning(J, omega), 20) <= 1e-14 * 20);
      }
}

TEST_CASE("inertia: a rod with moments 1e6 : 1 precesses as the closed form says, by steps") {
  // A symmetric body turns by |L|/A about L and by (1/C − 1/A) L₃ about its own axis.
  const double A = 1, C = 1e-6, T = 1e-2;
  const RigidBody<> body = test::body_with(Vec3(A, A, C));
  const RigidBodyState<> start{Vec3::Zero(), Quat(1, 0, 0, 0), Vec3::Zero(), Vec3(1, 0, 1e-3)};
  const Quat expected = exp_quaternion<double>(T / A * start.L) * start.q *
                        exp_quaternion(Vec3(0, 0, (1 / C - 1 / A) * 1e-3 * T));
  const PackedState<double> y =
      integrate_adaptive<Dop853>(RigidBodyRhs(body), pack(start), 0.0, T, {1e-13, 1e-13}).y;
  // ω is 1e-3/1e-6 = 1000 rad/s about the rod: 10 rad in all, and rounding of q enters as 1/C.
  CHECK(angle_between(unpack<double>(y).q, expected) <= 1e-9);
}

TEST_CASE("inertia: moments that differ by a thousandth, or by the last bit, or not at all") {
  for (const double part : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0x1p-52, 0.0})
    for (const Vec3& J : {Vec3(1, 1 + part, 1.5), Vec3(0.5, 1, 1 + part), Vec3(1, 1 + part, 1)}) {
      CAPTURE(part);
      CAPTURE(J.transpose());
      CHECK(error_after(J, test::turning(J, Vec3(0.3, 0.2, 1)), 20) <= 1e-14 * 20);
    }
}

TEST_CASE("inertia: in turned axes a small moment keeps what the entries of the tensor keep") {
  const Mat3 R = to_matrix(exp_quaternion(Vec3(1, 2, 3)));
  for (const double ratio : {1e-3, 1e-6, 1e-9, 1e-12}) {
    CAPTURE(ratio);
    const Mat3 I = R * Vec3(ratio, 1, 1 + ratio / 2).asDiagonal() * R.transpose();
    const RigidBody<> body(1, Mat3((I + I.transpose()) / 2));
    CHECK(std::abs(principal_axes(body.I_body()).moments[0] / ratio - 1) <= 8 * eps / ratio);
  }
}

TEST_CASE("inertia: what no body has is refused, and the message says why, with numbers") {
  const auto body = [](const Vec3& J) { return RigidBody<>(1, Mat3(J.asDiagonal())); };
  CHECK_REFUSED(body({1, 2, 3.0000001}), "triangle inequality", "1 + 2", "3.0000001, by 1e-07");
  CHECK_REFUSED(body({1e-12, 1, 1.1}), "triangle inequality", "1.1, by 0.1");
  CHECK_REFUSED(body({-1, 1, 1}), "not positive definite", "-1");
  CHECK_REFUSED(body({0, 1, 1}), "not positive definite", "(0, 1, 1)");
  CHECK_REFUSED(body({1, INFINITY, 1}), "not a finite number", "inf");
  Mat3 skewed = Mat3::Identity();
  skewed(0, 1) = 1e-3;
  CHECK_REFUSED(RigidBody<>(1, skewed), "not symmetric", "0.001");
  CHECK_REFUSED(RigidBody<>(0, Mat3::Identity()), "mass", "0", "not a positive");
  CHECK_REFUSED(RigidBody<>(NAN, Mat3::Identity()), "mass", "nan");
  CHECK_NOTHROW(body({1, 2, 3}));  // a lamina is the limit, up to rounding
  CHECK_NOTHROW(body({1, 2, 3 + 0x1p-50}));
}
