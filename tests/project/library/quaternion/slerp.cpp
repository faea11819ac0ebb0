#include "tumble/quaternion/slerp.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/quaternion/convert.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("slerp: a worked number, half way to a quarter turn is an eighth") {
  const Quat a(1, 0, 0, 0), b = from_axis_angle(Vec3::UnitZ(), std::numbers::pi / 2);
  CHECK(angle_between(slerp(a, b, 0.5), from_axis_angle(Vec3::UnitZ(), std::numbers::pi / 4)) <=
        4 * eps);
}

TEST_CASE("slerp: starts at a, ends at b, goes at a constant rate, the short way") {
  test::Random rng(91);
  for (const Vec3& w : test::rotation_vectors()) {
    const Quat a = exp_quaternion<double>(3 * rng.vector());
    const Quat b = a * exp_quaternion(w), opposite(-b.w(), -b.x(), -b.y(), -b.z());
    CAPTURE(w.transpose());
    for (const Quat& end : {b, opposite}) {
      CHECK(angle_between(slerp(a, end, 0.0), a) <= 16 * eps);
      CHECK(angle_between(slerp(a, end, 1.0), b) <= 16 * eps);
      for (const double t : {0.1, 0.25, 0.5, 0.9}) {
        const Quat between = slerp(a, end, t);
        CHECK(std::abs(between.norm() - 1) <= 16 * eps);
        CHECK(std::abs(angle_between(a, between) - t * w.norm()) <= 16 * eps);
        CHECK(std::abs(angle_between(between, b) - (1 - t) * w.norm()) <= 16 * eps);
      }
    }
  }
}

TEST_CASE("slerp: agrees with Shoemake's formula where that is well conditioned") {
  test::Random rng(92);
  for (int i = 0; i < 100; ++i) {
    const Quat a = exp_quaternion<double>(3 * rng.vector());
    const Quat b = a * exp_quaternion<double>(rng.uniform(0.5, 2.5) * rng.direction());
    const double arc = std::acos(a.dot(b)), t = rng.uniform(0, 1);
    const Eigen::Vector4d expected =
        (std::sin((1 - t) * arc) * a.coeffs() + std::sin(t * arc) * b.coeffs()) / std::sin(arc);
    // acos and 1/sin amplify by at most 1/sin(0.25) ≈ 4 each on this range.
    CHECK((slerp(a, b, t).coeffs() - expected).norm() <= 16 * 16 * eps);
  }
}
