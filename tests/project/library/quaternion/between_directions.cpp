#include "tumble/quaternion/between_directions.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble;
using test::eps;

TEST_CASE(
    "between_directions: takes a to b, about an axis across both, by the angle between them") {
  test::Random rng(93);
  for (const double angle : {0.0, 1e-300, 1e-9, 0.3, 1.5, 2.0, 2.2, 3.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 a = rng.direction(), axis = detail::perpendicular_to(a);
      const Vec3 b = exp_quaternion<double>(angle * axis) * a;
      const Quat q = detail::between_directions(a, b);
      CAPTURE(angle);
      CHECK(std::abs(q.norm() - 1) <= 8 * eps);
      CHECK((q * a - b).norm() <= 16 * eps);
      CHECK(std::abs(q.vec().dot(a)) <= 8 * eps);
      // b is rounded, which turns the axis by eps over the sine of the angle.
      CHECK((q.vec() - std::sin(angle / 2) * axis).norm() <= 8 * eps / std::cos(angle / 2));
    }
  }
}

TEST_CASE(
    "between_directions: keeps its digits where the directions are nearly opposite, or exactly") {
  test::Random rng(94);
  for (const double gap : {1e-2, 1e-5, 1.4e-6, 1e-8, 1e-12, 1e-15, 0.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 a = rng.direction(), b = (gap * rng.direction() - a).normalized();
      const Quat q = detail::between_directions(a, b);
      CAPTURE(gap);
      CHECK(std::abs(q.norm() - 1) <= 8 * eps);
      CHECK((q * a - b).norm() <= 16 * eps);
    }
  }
  CHECK(detail::between_directions(Vec3::UnitZ(), -Vec3::UnitZ()).w() == 0);
}

TEST_CASE("perpendicular_to: a unit vector across, for each axis too") {
  for (const Vec3& n : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6, 0.8, 0)}) {
    const Vec3 across = detail::perpendicular_to(n);
    CHECK(std::abs(across.norm() - 1) <= 4 * eps);
    CHECK(std::abs(across.dot(n)) <= 4 * eps);
  }
}
