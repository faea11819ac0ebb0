/// @file
/// 4.4 from_axis_angle: its laws, and what goes wrong.
#include <cmath>
#include <numbers>

#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;
using tumble::Vec3;

namespace student {
const Function<decltype(quaternions::from_axis_angle)> from_axis_angle{TUMBLE_UNIT};
}

namespace {

using reference::i, reference::j, reference::k, reference::one;
using std::numbers::pi;

/// The direction takes 5 roundings, its product with the sine 2, and as many in the reference. An
/// angle that is first brought into one turn is off by a rounding of itself.
double rounding(double angle) { return (16 + std::abs(angle)) * eps; }

/// (cos, sin · u) of some angle.
Quaternion of_half(double half, const Vec3& u) {
  Quaternion q;
  q << std::cos(half), std::sin(half) * u;
  return q;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any angle about any axis") {
    for (int n = 0; n < 30; ++n) {
      const Vec3 axis = any_vector(3);
      const double angle = any_number(-6, 6);
      REQUIRE(student::from_axis_angle(axis, angle) ==
              same_rotation(reference::from_axis_angle(axis, angle), rounding(angle)));
    }
  }

  TEST_CASE("quarter turns and half turns about x, y and z") {
    for (const Quaternion& unit : {i, j, k}) {
      const Vec3 axis = unit.tail<3>();
      const Quaternion quarter = std::sqrt(0.5) * (one + unit);
      REQUIRE(student::from_axis_angle(axis, pi / 2) == same_rotation(quarter, rounding(pi)));
      REQUIRE(student::from_axis_angle(axis, pi) == same_rotation(unit, rounding(pi)));
    }
  }

  TEST_CASE("an axis of any length, tiny or huge, gives the right turn, and q has length 1") {
    for (const double length : {1e-100, 1e-8, 0.5, 1e8, 1e100}) {
      const Vec3 axis = length * any_direction();
      const double angle = any_number(-6, 6);
      REQUIRE(student::from_axis_angle(axis, angle) ==
              same_rotation(reference::from_axis_angle(axis, angle), rounding(angle)));
    }
  }

  TEST_CASE("no turn at all, and a whole turn, are the rotation 1 about every axis") {
    for (const Vec3& axis :
         {any_vector(3), Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      REQUIRE(student::from_axis_angle(axis, 0) == same_rotation(one, rounding(0)));
      REQUIRE(student::from_axis_angle(axis, 2 * pi) == same_rotation(one, rounding(2 * pi)));
      REQUIRE(student::from_axis_angle(axis, -2 * pi) == same_rotation(one, rounding(2 * pi)));
    }
  }

  TEST_CASE("minus the angle is the right turn about the opposite axis") {
    const Vec3 axis = any_vector(3);
    const double angle = any_number(-3, 3);
    const Quaternion opposite = reference::from_axis_angle(-axis, angle);
    REQUIRE(student::from_axis_angle(axis, -angle) == same_rotation(opposite, rounding(angle)));
  }

  TEST_CASE("two right turns about one axis add their angles") {
    for (int n = 0; n < 20; ++n) {
      const Vec3 axis = any_vector(3);
      const double first = any_number(-3, 3), second = any_number(-3, 3);
      const Quaternion both = reference::product(reference::from_axis_angle(axis, second),
                                                 reference::from_axis_angle(axis, first));
      REQUIRE(student::from_axis_angle(axis, first + second) ==
              same_rotation(both, 2 * rounding(6)));
    }
  }

  TEST_CASE("tiny turns, and turns close to π") {
    for (const double angle : {1e-150, 1e-16, 1e-13, 1e-12, 1e-8, 1e-4, pi - 1e-4, pi - 1e-8,
                               pi - 1e-15, pi, pi + 1e-8}) {
      const Vec3 axis = any_vector(3);
      REQUIRE(student::from_axis_angle(axis, angle) ==
              same_rotation(reference::from_axis_angle(axis, angle), rounding(angle)));
    }
  }

  TEST_CASE("angles of many turns") {
    for (const double size : {1e2, 1e4, 1e6}) {
      const Vec3 axis = any_vector(3);
      const double angle = size * any_number(-1, 1);
      REQUIRE(student::from_axis_angle(axis, angle) ==
              same_rotation(reference::from_axis_angle(axis, angle), rounding(angle)));
    }
  }
}

const Misconceptions<decltype(quaternions::from_axis_angle)> misconceptions{
    TUMBLE_UNIT,
    {{"angle not halved",
      "Your quaternion turns by twice the angle: you multiply a point by it from both sides.",
      "Axis and angle",
      [](const Vec3& axis, double angle) { return of_half(angle, axis.normalized()); }},
     {"angle halved in the sine only",
      "Your scalar part is the cosine of the whole angle. Sine and cosine take the same half of "
      "it.",
      "Axis and angle",
      [](const Vec3& axis, double angle) {
        Quaternion q = reference::from_axis_angle(axis, angle);
        q[0] = std::cos(angle);
        return q;
      }},
     {"angle halved in the cosine only",
      "Your vector part has the sine of the whole angle. Sine and cosine take the same half of it.",
      "Axis and angle",
      [](const Vec3& axis, double angle) {
        Quaternion q = of_half(angle, axis.normalized());
        q[0] = std::cos(angle / 2);
        return q;
      }},
     {"axis not normalised",
      "Your vector part grows with the length of the axis. Of the axis only the direction counts.",
      "Axis and angle", [](const Vec3& axis, double angle) { return of_half(angle / 2, axis); }},
     {"quaternion normalised instead of the axis",
      "Your result has length 1, but another angle: the length of the axis had already changed the "
      "ratio of vector to scalar.",
      "Axis and angle",
      [](const Vec3& axis, double angle) -> Quaternion {
        return of_half(angle / 2, axis).stableNormalized();
      }},
     {"degrees for radians",
      "You have taken the angle for degrees and converted it. It comes in radians, as the sine "
      "wants it.",
      "Conventions",
      [](const Vec3& axis, double angle) {
        return reference::from_axis_angle(axis, angle * pi / 180);
      }},
     {"sine and cosine swapped",
      "No turn at all must be (1, 0, 0, 0). Which of sine and cosine is 1 at zero?",
      "Axis and angle",
      [](const Vec3& axis, double angle) {
        Quaternion q;
        q << std::sin(angle / 2), std::cos(angle / 2) * axis.normalized();
        return q;
      }},
     {"turned the other way",
      "Your quaternion turns by −angle: it leads from world to body. Here q takes body axes to "
      "world axes.",
      "Conventions",
      [](const Vec3& axis, double angle) { return reference::from_axis_angle(axis, -angle); }},
     {"scalar stored last",
      "Your numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions", [](const Vec3& axis, double angle) {
        return reference::store_scalar_last(reference::from_axis_angle(axis, angle));
      }}}};
