#include "tumble/body/rigid_body.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("RigidBody: holds the inverse of its inertia tensor, at every size of body") {
  test::Random rng(101);
  for (const double size : {1e-24, 1e-6, 1.0, 1e6, 1e24}) {
    CAPTURE(size);
    for (const Vec3& moments : {Vec3(1, 2, 2.5), Vec3(1, 1, 1), Vec3(1e-6, 1, 1)}) {
      const Mat3 R = exp_rotation<double>(3 * rng.vector());
      const Mat3 I = size * size * size * size * size * R * moments.asDiagonal() * R.transpose();
      const Mat3 symmetric = (I + I.transpose()) / 2;
      const RigidBody<> body(size * size * size, symmetric);
      const double condition = moments.maxCoeff() / moments.minCoeff();
      CHECK((body.I_body() * body.I_body_inv() - Mat3::Identity()).norm() <= 16 * eps * condition);
    }
  }
}

TEST_CASE("RigidBody: what no body has is refused") {
  const Mat3 good = Vec3(1, 2, 2.5).asDiagonal();
  CHECK_REFUSED(RigidBody<>(0, good), "mass", "0");
  CHECK_REFUSED(RigidBody<>(-1, good), "mass", "-1");
  CHECK_REFUSED(RigidBody<>(NAN, good), "mass", "nan");
  CHECK_REFUSED(RigidBody<>(1, Mat3(Vec3(1, 1, 3).asDiagonal())), "triangle inequality");
  CHECK_REFUSED(RigidBody<>(1, Mat3(Vec3(0, 1, 1).asDiagonal())), "positive definite");
  CHECK_REFUSED(RigidBody<>(1, Mat3(Vec3(-1, 1, 1).asDiagonal())), "positive definite");
  Mat3 skewed = good;
  skewed(0, 1) = 0.1;
  CHECK_REFUSED(RigidBody<>(1, skewed), "not symmetric");
  CHECK_REFUSED(RigidBody<>(MassProperties{}), "mass", "nan");
}
