/// @file
/// 4.8 quaternion_dot: its laws, and what goes wrong.
#include <cmath>

#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;
using tumble::Vec3;

namespace student {
const Function<decltype(quaternions::quaternion_dot)> quaternion_dot{TUMBLE_UNIT};
}

namespace {

using reference::one;

/// A number of q̇ takes 4 roundings of at most ½ |ω| |q|, and as many in the reference; room for
/// another order.
double rounding(const Quaternion& q, const Vec3& omega) {
  return 8 * eps * omega.norm() * q.norm();
}

Quaternion pure(const Vec3& v) { return {0, v.x(), v.y(), v.z()}; }

/// The orientation a time t after q, at the constant angular velocity ω.
Quaternion spun(const Quaternion& q, const Vec3& omega, double t) {
  return reference::product(reference::from_axis_angle(omega, t * omega.norm()), q);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the rate of any q, of whatever length, under any ω in world axes") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_quaternion();
      const Vec3 omega = any_vector(3);
      REQUIRE(student::quaternion_dot(q, omega) ==
              close_to(reference::quaternion_dot(q, omega), rounding(q, omega)));
    }
  }

  TEST_CASE("it is the derivative of the orientation of a body that spins at constant ω") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_unit_quaternion();
      const Vec3 omega = any_vector(3);
      const double h = 0x1p-13, half = omega.norm() / 2;
      const Quaternion difference = (spun(q, omega, h) - spun(q, omega, -h)) / (2 * h);
      // q‴ = −(½|ω|)² q̇: the difference is off by h²/6 |q‴|, and each q by about 32 roundings.
      const double bound = h * h / 6 * half * half * half + 32 * eps / h;
      REQUIRE(student::quaternion_dot(q, omega) == close_to(difference, bound));
    }
  }

  TEST_CASE("a point of the body moves at ω × r") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_unit_quaternion();
      const Vec3 omega = any_vector(3), p = any_vector();
      const auto rate = student::quaternion_dot(q, omega);
      const double h = 0x1p-13;
      const Quaternion before = q - h * rate.value(), after = q + h * rate.value();
      const Vec3 velocity = (reference::rotate(after, p) - reference::rotate(before, p)) / (2 * h);
      const Vec3 expected = omega.cross(reference::rotate(q, p));
      // q ± h q̇ is turned by 2 atan(½ h |ω|): the velocity is short by (½ h |ω|)² of itself. Each
      // place is off by about 32 roundings a number.
      const double step = h * omega.norm() / 2;
      REQUIRE(rate == obeys("ṙ = ω × r", (velocity - expected).norm(),
                            step * step * expected.norm() + 64 * eps * p.norm() / h));
    }
  }

  TEST_CASE("q·q̇ = 0: to first order the length of q stays") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_quaternion();
      const Vec3 omega = any_vector(3);
      const auto rate = student::quaternion_dot(q, omega);
      // Each of the four numbers is off by `rounding` at most, and so is the product itself.
      REQUIRE(rate ==
              obeys("q·q̇ = 0", std::abs(q.dot(rate.value())), 4 * rounding(q, omega) * q.norm()));
    }
  }

  TEST_CASE("in the orientation 1 the rate is half of ω") {
    const Vec3 omega = any_vector(3);
    REQUIRE(student::quaternion_dot(one, omega) == close_to(pure(omega / 2), rounding(one, omega)));
  }

  TEST_CASE("twice the quaternion or twice the ω is twice the rate, and −q moves opposite to q") {
    const Quaternion q = any_quaternion();
    const Vec3 omega = any_vector(3);
    const auto rate = student::quaternion_dot(q, omega);
    const Quaternion twice = 2 * rate.value(), opposite = -rate.value();
    REQUIRE(student::quaternion_dot(2 * q, omega) == close_to(twice, 4 * rounding(q, omega)));
    REQUIRE(student::quaternion_dot(q, 2 * omega) == close_to(twice, 4 * rounding(q, omega)));
    REQUIRE(student::quaternion_dot(-q, omega) == close_to(opposite, 2 * rounding(q, omega)));
  }

  TEST_CASE("nothing moves without ω, and tiny and huge spins are what they are") {
    const Quaternion q = any_unit_quaternion();
    for (const double size : {0., 1e-150, 1e150}) {
      const Vec3 omega = size * any_direction();
      REQUIRE(student::quaternion_dot(q, omega) ==
              close_to(reference::quaternion_dot(q, omega), rounding(q, omega)));
    }
  }
}

const Misconceptions<decltype(quaternions::quaternion_dot)> misconceptions{
    TUMBLE_UNIT,
    {{"factor ½ forgotten",
      "With your rate the body turns twice as fast: the quaternion holds half the angle.",
      "Angular velocity",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return 2 * reference::quaternion_dot(q, omega);
      }},
     {"factor ½ twice",
      "With your rate the body turns at half its speed: your product has the factor ½ twice.",
      "Angular velocity",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return reference::quaternion_dot(q, omega / 2);
      }},
     {"factor 2 for ½",
      "With your rate the body turns four times as fast: you multiplied by 2, where the "
      "quaternion holds half the angle.",
      "Angular velocity",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return reference::quaternion_dot(q, 4 * omega);
      }},
     {"ω taken in body axes",
      "You have swapped the factors. With ω on the other side the product is right for an ω in "
      "body axes; here ω is in world axes.",
      "Angular velocity",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return reference::product(q, pure(omega / 2));
      }},
     {"ω turned into body axes first",
      "You have turned ω by q⁻¹ and then used it as if it were in world axes. It comes in world "
      "axes.",
      "Angular velocity",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return reference::quaternion_dot(q, reference::to_matrix(q).transpose() * omega);
      }},
     {"wrong sign of ω", "With your rate the body turns backwards.", "Angular velocity",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return -reference::quaternion_dot(q, omega);
      }},
     {"scalar part 1 for ω",
      "You have put ω into the product as ⟨1, ω⟩, and that lets q grow. As a quaternion a vector "
      "has no scalar part.",
      "Angular velocity",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return reference::quaternion_dot(q, omega) + q / 2;
      }},
     {"ω in the places of w, x and y",
      "You have put ω into the product as (ω, 0), its scalar part last. Here w comes first: q[0] "
      "is the scalar.",
      "Conventions",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return 0.5 * reference::product({omega[0], omega[1], omega[2], 0}, q);
      }},
     {"q normalised first",
      "This is the rate of q/|q|. The rate is linear in q: repair the length between the steps, "
      "not here.",
      "Drift",
      [](const Quaternion& q, const Vec3& omega) {
        return reference::quaternion_dot(q.normalized(), omega);
      }},
     {"rate normalised",
      "Your result has length 1. A rate is not a rotation: its length says how fast q moves.",
      "Drift",
      [](const Quaternion& q, const Vec3& omega) -> Quaternion {
        return reference::quaternion_dot(q, omega).stableNormalized();
      }},
     {"scalar read from the end",
      "You read w where z is, and store it first. A Quaternion is an Eigen::Vector4d, and w() of a "
      "Vector4d is the last of its four numbers. Here q[0] is the scalar.",
      "Conventions",
      [](const Quaternion& q, const Vec3& omega) {
        return reference::quaternion_dot(reference::read_scalar_last(q), omega);
      }},
     {"scalar stored last",
      "Your numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions", [](const Quaternion& q, const Vec3& omega) {
        return reference::store_scalar_last(
            reference::quaternion_dot(reference::read_scalar_last(q), omega));
      }}}};
