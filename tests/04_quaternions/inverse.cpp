/// @file
/// 4.2 inverse: its laws, and what goes wrong.
#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;

namespace student {
const Function<decltype(quaternions::inverse)> inverse{TUMBLE_UNIT};
}

namespace {

using reference::i, reference::j, reference::k, reference::one;

/// A sum of four squares and a quotient are 5 roundings of at most 1/|q|, and as many in the
/// reference; room for a way through √.
double rounding(const Quaternion& q) { return 16 * eps / q.norm(); }

/// A relative error of 16 eps in each of four numbers has at most twice that length.
constexpr double relative = 32 * eps;

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any quaternion but zero has an inverse, whatever its length") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_quaternion();
      REQUIRE(student::inverse(q) == close_to(reference::inverse(q), rounding(q)));
    }
  }

  TEST_CASE("q q⁻¹ = 1 and q⁻¹ q = 1") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_quaternion();
      const auto answer = student::inverse(q);
      const Quaternion right = reference::product(q, answer), left = reference::product(answer, q);
      REQUIRE(answer == obeys("q q⁻¹ = 1", (right - one).norm(), 2 * relative));
      REQUIRE(answer == obeys("q⁻¹ q = 1", (left - one).norm(), 2 * relative));
    }
  }

  TEST_CASE("a little drift from length 1 counts: the inverse is right to rounding there, too") {
    for (const double drift : {-1e-13, 1e-13, 1e-12, 1e-9, 1e-6, 1e-3}) {
      const Quaternion q = (1 + drift) * any_unit_quaternion();
      REQUIRE(student::inverse(q) == close_to(reference::inverse(q), rounding(q)));
    }
  }

  TEST_CASE("the inverse of a turn is the same turn backwards; minus the inverse won't do") {
    for (int n = 0; n < 20; ++n) {
      const tumble::Vec3 axis = any_direction();
      const double angle = any_number(-3, 3);
      const Quaternion forth = reference::from_axis_angle(axis, angle);
      const Quaternion back = reference::from_axis_angle(axis, -angle);
      REQUIRE(student::inverse(forth) == close_to(back, 2 * rounding(forth)));
    }
  }

  TEST_CASE("1 and −1 undo themselves, −i undoes i, −j undoes j, −k undoes k") {
    for (const Quaternion& self : {one, Quaternion(-one)})
      REQUIRE(student::inverse(self) == close_to(self, rounding(self)));
    for (const Quaternion& unit : {i, j, k})
      REQUIRE(student::inverse(unit) == close_to(Quaternion(-unit), rounding(unit)));
  }

  TEST_CASE("the inverse of the inverse is q again") {
    const Quaternion q = any_quaternion();
    REQUIRE(student::inverse(student::inverse(q)) == close_to(q, 2 * relative * q.norm()));
  }

  TEST_CASE("(a b)⁻¹ is the true b⁻¹ times the true a⁻¹: what was done last is undone first") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion a = any_quaternion(), b = any_quaternion();
      const Quaternion expected = reference::product(reference::inverse(b), reference::inverse(a));
      REQUIRE(student::inverse(reference::product(a, b)) ==
              close_to(expected, 2 * relative * expected.norm()));
    }
  }

  TEST_CASE("tiny and huge quaternions have huge and tiny inverses") {
    for (const double length : {1e-100, 1e-8, 1e8, 1e100}) {
      const Quaternion q = length * any_unit_quaternion();
      REQUIRE(student::inverse(q) == close_to(reference::inverse(q), rounding(q)));
    }
  }
}

const Misconceptions<decltype(quaternions::inverse)> misconceptions{
    TUMBLE_UNIT,
    {{"only conjugated",
      "This is the inverse of a unit quaternion only. Here q may have any length, and the length "
      "of the inverse is 1/|q|.",
      "The inverse", [](const Quaternion& q) { return reference::conjugate(q); }},
     {"divided by the length, not its square",
      "The direction is right, but your result has length 1 whatever q is: q times its conjugate "
      "is |q|², not |q|.",
      "The inverse",
      [](const Quaternion& q) -> Quaternion { return reference::conjugate(q) / q.norm(); }},
     {"not conjugated",
      "The length is right, but your quaternion turns on in the same direction instead of back.",
      "The inverse",
      [](const Quaternion& q) -> Quaternion {
        return reference::conjugate(reference::inverse(q));
      }},
     {"all four signs turned",
      "−q is the same rotation as q, so −q/|q|² undoes nothing. Only the axis changes direction.",
      "The inverse",
      [](const Quaternion& q) -> Quaternion {
        return -reference::conjugate(reference::inverse(q));
      }},
     {"sign of the scalar turned",
      "This is minus the inverse. It is the same rotation, but q q⁻¹ must be 1 and yours is −1. "
      "Which part of q holds the direction of the axis?",
      "The inverse", [](const Quaternion& q) -> Quaternion { return -reference::inverse(q); }},
     {"inverted entry by entry",
      "One over each number is not the inverse: the product mixes all four numbers.", "The inverse",
      [](const Quaternion& q) -> Quaternion { return q.cwiseInverse(); }},
     {"scalar read from the end",
      "You read w where z is, and store it first. A Quaternion is an Eigen::Vector4d, and w() of a "
      "Vector4d is the last of its four numbers. Here q[0] is the scalar.",
      "Conventions",
      [](const Quaternion& q) { return reference::inverse(reference::read_scalar_last(q)); }},
     {"scalar stored last",
      "Your numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions", [](const Quaternion& q) {
        return reference::store_scalar_last(reference::inverse(reference::read_scalar_last(q)));
      }}}};
