#include "tumble/quaternion/exp_log.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("exp_quaternion: a worked number") {
  const Quat q = exp_quaternion(Vec3(std::numbers::pi / 2, 0, 0));
  CHECK((coefficients(q) - Eigen::Vector4d(std::sqrt(0.5), std::sqrt(0.5), 0, 0)).norm() <=
        2 * eps);
}

TEST_CASE("exp_quaternion: is a unit quaternion, and the same rotation as exp_rotation") {
  for (const Vec3& w : test::rotation_vectors()) {
    CAPTURE(w.transpose());
    const Quat q = exp_quaternion(w);
    CHECK(std::abs(q.norm() - 1) <= 4 * eps);
    CHECK((to_matrix(q) - exp_rotation(w)).norm() <= 16 * eps);
  }
}

TEST_CASE("log_quaternion: takes back exp to a relative rounding error, from 1e-300 to π") {
  for (const Vec3& w : test::rotation_vectors()) {
    CAPTURE(w.transpose());
    const Quat q = exp_quaternion(w), opposite(-q.w(), -q.x(), -q.y(), -q.z());
    for (const Quat& sign : {q, opposite}) {
      const Vec3 back = log_quaternion(sign);
      CHECK(back.stableNorm() <= std::numbers::pi * (1 + 2 * eps));
      // At π, up to the rounding of w itself, both signs of w are right.
      const bool half_turn = w.stableNorm() > std::numbers::pi * (1 - 4 * eps);
      const double error = half_turn ? std::min((back - w).stableNorm(), (back + w).stableNorm())
                                     : (back - w).stableNorm();
      CHECK(error <= 8 * eps * w.stableNorm());
    }
  }
}

TEST_CASE("angle_between: knows a turn of 1e-12, and that q and −q are one rotation") {
  test::Random rng(71);
  for (const double angle : {0.0, 1e-12, 1e-8, 1e-3, 1.0, 3.0}) {
    CAPTURE(angle);
    const Quat a = exp_quaternion<double>(3 * rng.vector());
    const Quat b = exp_quaternion<double>(angle * rng.direction()) * a;
    const Quat opposite(-b.w(), -b.x(), -b.y(), -b.z());
    CHECK(std::abs(angle_between(a, b) - angle) <= 8 * eps);
    CHECK(angle_between(a, b) == angle_between(a, opposite));
  }
}
