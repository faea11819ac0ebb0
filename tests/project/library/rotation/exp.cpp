#include "tumble/rotation/exp.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/orthonormality.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("exp_rotation: a worked number") {
  const Mat3 R = exp_rotation(Vec3(0, 0, std::numbers::pi / 2));
  CHECK((R * Vec3::UnitX() - Vec3::UnitY()).norm() <= 2 * eps);
}

TEST_CASE("exp_rotation: is a rotation that leaves its axis alone") {
  for (const Vec3& w : test::rotation_vectors()) {
    CAPTURE(w.transpose());
    const Mat3 R = exp_rotation(w);
    // θ² [u]×² has entries up to π², each with its rounding.
    CHECK(rotation::is_rotation(R, 32 * eps));
    CHECK((R * w - w).norm() <= 8 * eps * w.norm());
  }
}

TEST_CASE("log_rotation: takes back exp_rotation from 1e-300 to π") {
  for (const Vec3& w : test::rotation_vectors()) {
    CAPTURE(w.transpose());
    const Mat3 R = exp_rotation(w);
    const Vec3 back = log_rotation(R);
    CHECK(back.norm() <= std::numbers::pi * (1 + 2 * eps));
    // R holds w to an absolute rounding error; at π the sign of w is lost with it.
    const double error = std::min((back - w).norm(), (back + w).norm());
    const bool near_pi = w.norm() > std::numbers::pi - 1e-12;
    CHECK((near_pi ? error : (back - w).norm()) <= 16 * eps * std::max(w.norm(), 1e-300 / eps));
    CHECK((exp_rotation(back) - R).norm() <= 16 * eps);
  }
}

TEST_CASE("exp_rotation: turns about one axis add up") {
  test::Random rng(31);
  for (int i = 0; i < 100; ++i) {
    const Vec3 axis = rng.direction();
    const double a = rng.uniform(-10, 10), b = rng.uniform(-10, 10);
    const Mat3 both = exp_rotation<double>(a * axis) * exp_rotation<double>(b * axis);
    CHECK((both - exp_rotation<double>((a + b) * axis)).norm() <= 16 * eps * (1 + 10));
  }
}

TEST_CASE("log_rotation: what is no rotation is refused") {
  CHECK_REFUSED(log_rotation(Mat3(-Mat3::Identity())), "not a rotation matrix", "determinant -1");
  CHECK_REFUSED(log_rotation(Mat3(2 * Mat3::Identity())), "not a rotation matrix");
  CHECK_REFUSED(log_rotation(Mat3(NAN * Mat3::Identity())), "not a rotation matrix", "nan");
}
