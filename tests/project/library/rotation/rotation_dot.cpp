#include "tumble/rotation/rotation_dot.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("rotation_dot: a worked number, the x axis under a spin about z moves along y") {
  const Mat3 R_dot = rotation::rotation_dot(Mat3(Mat3::Identity()), Vec3(0, 0, 3));
  CHECK(Vec3(R_dot.col(0)) == Vec3(0, 3, 0));
}

TEST_CASE("rotation_dot: each axis of the body moves as ω × axis") {
  test::Random rng(51);
  for (const Vec3& w : test::rotation_vectors()) {
    const Mat3 R = exp_rotation(w);
    const Vec3 omega = 10 * rng.vector();
    const Mat3 R_dot = rotation::rotation_dot(R, omega);
    for (int axis = 0; axis < 3; ++axis)
      CHECK((R_dot.col(axis) - omega.cross(Vec3(R.col(axis)))).norm() <= 8 * eps * omega.norm());
  }
}

TEST_CASE("rotation_dot: is the derivative of exp([ω]× t) R, in world and in body coordinates") {
  test::Random rng(52);
  constexpr double h = 1e-5;  // central difference: h² ω³/6 from the series, eps/h from rounding
  for (int i = 0; i < 50; ++i) {
    const Mat3 R = exp_rotation<double>(3 * rng.vector());
    const Vec3 omega = rng.vector();
    const Mat3 later = exp_rotation<double>(h * omega) * R,
               earlier = exp_rotation<double>(-h * omega) * R;
    const Mat3 slope = (later - earlier) / (2 * h);
    CHECK((rotation::rotation_dot(R, omega) - slope).norm() <= h * h + 16 * eps / h);
    const Vec3 omega_body = R.transpose() * omega;
    CHECK((rotation::rotation_dot_body(R, omega_body) - slope).norm() <= h * h + 16 * eps / h);
  }
}

TEST_CASE("angular_velocity: reads ω back from Ṙ") {
  test::Random rng(53);
  for (const Vec3& w : test::rotation_vectors()) {
    const Mat3 R = exp_rotation(w);
    const Vec3 omega = rng.vector();
    CHECK((rotation::angular_velocity_of(R, rotation::rotation_dot(R, omega)) - omega).norm() <=
          16 * eps * omega.norm());
  }
}
