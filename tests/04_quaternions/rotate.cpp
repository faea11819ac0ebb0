/// @file
/// 4.3 rotate: its laws, and what goes wrong.
#include <cmath>

#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;
using tumble::Vec3;

namespace student {
const Function<decltype(quaternions::rotate)> rotate{TUMBLE_UNIT};
}

namespace {

using reference::one;

/// Two products and an inverse are about 22 roundings of at most |p|, the matrix of the reference
/// 20; room for another order.
double rounding(const Vec3& p) { return 64 * eps * p.norm(); }

/// q p q⁻¹ or what a mistake makes of it, without the scalar.
Vec3 between(const Quaternion& left, const Vec3& p, const Quaternion& right) {
  Quaternion all = Quaternion::Zero();
  all.tail<3>() = p;
  all = reference::product(left, all);
  all = reference::product(all, right);
  return all.tail<3>();
}

/// p + 2w u × p + 2 u × (u × p), with u the vector part of q.
Vec3 by_cross_products(const Quaternion& q, double w, const Vec3& p) {
  const Vec3 u = q.tail<3>(), across = 2 * u.cross(p);
  return p + w * across + u.cross(across);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("a point is turned from body to world axes, by a quaternion of any length") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_quaternion();
      const Vec3 p = any_vector(3);
      REQUIRE(student::rotate(q, p) == close_to(reference::rotate(q, p), rounding(p)));
    }
  }

  TEST_CASE(
      "a quarter turn about z takes x to y, about x it takes y to z, about y it takes z to x") {
    const double h = std::sqrt(0.5);
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    REQUIRE(student::rotate(Quaternion(h, 0, 0, h), x) == close_to(y, rounding(x)));
    REQUIRE(student::rotate(Quaternion(h, h, 0, 0), y) == close_to(z, rounding(y)));
    REQUIRE(student::rotate(Quaternion(h, 0, h, 0), z) == close_to(x, rounding(z)));
  }

  TEST_CASE("the distance from the origin stays, however little or far q has drifted") {
    for (const double drift :
         {0., 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1., -1e-12, -1e-9, -1e-6, -1e-3, -0.1, -0.9}) {
      const Quaternion q = (1 + drift) * any_unit_quaternion();
      const Vec3 p = any_vector(3);
      const auto answer = student::rotate(q, p);
      // Three numbers that are each off by `rounding` make a length off by at most √3 of it.
      REQUIRE(answer ==
              obeys("|q p q⁻¹| = |p|", std::abs(answer->norm() - p.norm()), 2 * rounding(p)));
    }
  }

  TEST_CASE("a b turns by b first and then by a") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion a = any_unit_quaternion(), b = any_unit_quaternion();
      const Vec3 p = any_vector(3);
      const auto one_by_one = student::rotate(a, student::rotate(b, p));
      REQUIRE(student::rotate(reference::product(a, b), p) ==
              close_to(one_by_one.value(), 4 * rounding(p)));
    }
  }

  TEST_CASE("q and −q, of any length, turn a point alike, and to the right place") {
    const Quaternion q = any_quaternion();
    const Vec3 p = any_vector(3);
    REQUIRE(student::rotate(-q, p) == close_to(reference::rotate(q, p), rounding(p)));
  }

  TEST_CASE("1 moves nothing, and no turn moves a point of its axis") {
    const Vec3 p = any_vector(3);
    REQUIRE(student::rotate(one, p) == close_to(p, rounding(p)));
    const Quaternion q = any_quaternion();
    const Vec3 on_axis = q.tail<3>();
    REQUIRE(student::rotate(q, on_axis) == close_to(on_axis, rounding(on_axis)));
  }

  TEST_CASE("a half turn about u takes p to 2 (u·p) u − p") {
    const Vec3 u = any_direction(), p = any_vector(3);
    const Vec3 expected = 2 * u.dot(p) * u - p;
    REQUIRE(student::rotate(Quaternion(0, u.x(), u.y(), u.z()), p) ==
            close_to(expected, rounding(p)));
  }

  TEST_CASE("points at the origin, near it and far away, and tiny and huge quaternions") {
    for (const double size : {0., 1e-150, 1e150}) {
      const Quaternion q = any_unit_quaternion();
      const Vec3 p = size * any_vector(3);
      REQUIRE(student::rotate(q, p) == close_to(reference::rotate(q, p), rounding(p)));
    }
    for (const double length : {1e-100, 1e-8, 1e8, 1e100}) {
      const Quaternion q = length * any_unit_quaternion();
      const Vec3 p = any_vector(3);
      REQUIRE(student::rotate(q, p) == close_to(reference::rotate(q, p), rounding(p)));
    }
  }
}

const Misconceptions<decltype(quaternions::rotate)> misconceptions{
    TUMBLE_UNIT,
    {{"turned the other way",
      "This is q⁻¹ p q, which takes world axes to body axes. Look at which side your "
      "inverse is on.",
      "Rotating a point",
      [](const Quaternion& q, const Vec3& p) { return between(reference::inverse(q), p, q); }},
     {"conjugate for inverse",
      "The direction is right, but you scale the point by |q|². Conjugate and inverse are the same "
      "for unit quaternions only, and q drifts.",
      "The inverse",
      [](const Quaternion& q, const Vec3& p) { return between(q, p, reference::conjugate(q)); }},
     {"divided by the length, not its square",
      "The direction is right, but you scale the point by |q|: q is in the product twice.",
      "The inverse",
      [](const Quaternion& q, const Vec3& p) -> Vec3 {
        return between(q, p, reference::conjugate(q)) / q.norm();
      }},
     {"right for unit quaternions only",
      "Your formula takes for granted that |q| = 1. q drifts: the square of its length belongs "
      "in the formula, or q gets the length 1 first.",
      "The inverse",
      [](const Quaternion& q, const Vec3& p) { return by_cross_products(q, q[0], p); }},
     {"w left out",
      "Your formula uses the vector part of q alone. Its length is the sine of the half angle; "
      "without the cosine, which is w, you have no rotation.",
      "Rotating a point",
      [](const Quaternion& q, const Vec3& p) { return by_cross_products(q, 1, p); }},
     {"multiplied from one side only",
      "This is the vector part of q p. One factor alone turns by half the angle and leaves a "
      "scalar part behind; the second factor finishes the turn.",
      "Rotating a point",
      [](const Quaternion& q, const Vec3& p) { return between(q, p, reference::one); }},
     {"q on both sides", "This is q p q. What is on the right must undo what is on the left.",
      "Rotating a point", [](const Quaternion& q, const Vec3& p) { return between(q, p, q); }},
     {"result normalised",
      "You have put the point on the unit sphere. It is a place, not a direction: its distance "
      "from the origin has to stay.",
      "Rotating a point",
      [](const Quaternion& q, const Vec3& p) -> Vec3 {
        return reference::rotate(q, p).stableNormalized();
      }},
     {"scalar stored last",
      "Your numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions", [](const Quaternion& q, const Vec3& p) {
        return reference::rotate(reference::read_scalar_last(q), p);
      }}}};
