/// @file
/// 4.7 slerp: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;
using tumble::Vec3;

namespace student {
const Function<decltype(quaternions::slerp)> slerp{TUMBLE_UNIT};
}

namespace {

using reference::one;
using std::numbers::pi;

/// The reference takes about 20 roundings of at most 1, the two sines over a sine about 16, each up
/// to doubled where t is outside [0, 1].
constexpr double rounding = 96 * eps;

/// b or −b, whichever is nearer to a.
Quaternion nearer(const Quaternion& a, const Quaternion& b) {
  const double cosine = a.dot(b);
  return cosine < 0 ? Quaternion(-b) : b;
}

/// The arc over `angle` from a to b, with two sines over a sine.
Quaternion arc(const Quaternion& a, const Quaternion& b, double angle, double t) {
  const double done = t * angle, left = (1 - t) * angle;
  const Quaternion sum = std::sin(left) * a + std::sin(done) * b;
  return sum / std::sin(angle);
}

Quaternion line(const Quaternion& a, const Quaternion& b, double t) { return (1 - t) * a + t * b; }

/// The turn by `angle` about any axis, after a.
Quaternion turned(const Quaternion& a, double angle) {
  return reference::product(reference::from_axis_angle(any_direction(), angle), a);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("between any two orientations at constant angular velocity, the short way round") {
    for (int n = 0; n < 30; ++n) {
      const Quaternion a = any_unit_quaternion(), b = any_unit_quaternion();
      const double t = any_number(0, 1);
      REQUIRE(student::slerp(a, b, t) == same_rotation(reference::slerp(a, b, t), rounding));
    }
  }

  TEST_CASE("t = 0 is a and t = 1 is b") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion a = any_unit_quaternion(), b = any_unit_quaternion();
      REQUIRE(student::slerp(a, b, 0) == same_rotation(a, rounding));
      REQUIRE(student::slerp(a, b, 1) == same_rotation(b, rounding));
    }
  }

  TEST_CASE("between a and a there is only a, and −a is a too") {
    for (const Quaternion& a : {one, reference::j, any_unit_quaternion(), any_unit_quaternion()})
      for (const double t : {0., 0.3, 1.}) {
        REQUIRE(student::slerp(a, a, t) == same_rotation(a, rounding));
        REQUIRE(student::slerp(a, -a, t) == same_rotation(a, rounding));
      }
  }

  TEST_CASE("between nearly equal orientations it is right to rounding") {
    // The cosine between these two is rounded to 1, in whatever order it is summed.
    const Quaternion close = turned(one, 1e-8);
    REQUIRE(student::slerp(one, close, 0.3) ==
            same_rotation(reference::slerp(one, close, 0.3), rounding));
    for (const double angle : {3e-2, 1e-3, 1e-5, 1e-7, 1e-8, 1e-10, 1e-15})
      for (const double sign : {1., -1.}) {
        const Quaternion a = any_unit_quaternion(), b = sign * turned(a, angle);
        const double t = any_number(0.1, 0.4);  // at ½ a straight line is as good
        REQUIRE(student::slerp(a, b, t) == same_rotation(reference::slerp(a, b, t), rounding));
      }
  }

  TEST_CASE(
      "about one axis the angles are interpolated: a third of the way is a third of the turn") {
    for (int n = 0; n < 20; ++n) {
      const Vec3 axis = any_direction();
      const double angle = any_number(-3, 3), t = any_number(0, 1);
      REQUIRE(student::slerp(one, reference::from_axis_angle(axis, angle), t) ==
              same_rotation(reference::from_axis_angle(axis, t * angle), rounding));
    }
    // Not only from 1 on: between two turns about the axis, up to 2.9 rad apart.
    for (const double t : {1 / 3., 2 / 3., any_number(0, 1)}) {
      const Vec3 axis = any_direction();
      const double from = any_number(-3, 3), way = any_number(1, 2.9);
      const Quaternion a = reference::from_axis_angle(axis, from),
                       b = reference::from_axis_angle(axis, from + way),
                       expected = reference::from_axis_angle(axis, from + t * way);
      REQUIRE(student::slerp(a, b, t) == same_rotation(expected, rounding));
      REQUIRE(student::slerp(b, a, 1 - t) == same_rotation(expected, rounding));
    }
  }

  TEST_CASE("from a to b and from b to a is the same way, the right one: t there is 1 − t here") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion a = any_unit_quaternion(), b = any_unit_quaternion();
      const double t = any_number(0, 1);
      const auto there = student::slerp(a, b, t);
      REQUIRE(there == same_rotation(reference::slerp(a, b, t), rounding));
      REQUIRE(student::slerp(b, a, 1 - t) == same_rotation(there.value(), 2 * rounding));
    }
  }

  TEST_CASE("nearly half a turn apart there is one short way, at half a turn either way is right") {
    for (const double angle : {pi - 1e-2, pi - 1e-6, pi - 1e-10}) {
      const Quaternion a = any_unit_quaternion(), b = turned(a, angle);
      const double t = any_number(0, 1);
      REQUIRE(student::slerp(a, b, t) == same_rotation(reference::slerp(a, b, t), rounding));
    }
    const double t = any_number(0, 1);
    const Quaternion one_way(std::cos(t * pi / 2), std::sin(t * pi / 2), 0, 0);
    const Quaternion other_way = reference::conjugate(one_way);
    const auto answer = student::slerp(one, reference::i, t);
    const auto off = [&](const Quaternion& way) {
      return std::fmin((answer.value() - way).norm(), (answer.value() + way).norm());
    };
    const bool is_one_way = off(one_way) < off(other_way);
    REQUIRE(answer == same_rotation(is_one_way ? one_way : other_way, rounding));
  }

  TEST_CASE("before a and after b the turn goes on at the same rate") {
    for (const double t : {-1., -0.4, 1.3, 2.}) {
      const Quaternion a = any_unit_quaternion(), b = any_unit_quaternion();
      REQUIRE(student::slerp(a, b, t) == same_rotation(reference::slerp(a, b, t), rounding));
    }
  }
}

const Misconceptions<decltype(quaternions::slerp)> misconceptions{
    TUMBLE_UNIT,
    {{"the long way round",
      "Where a·b is negative, you go the long way: q and −q are one rotation, and your goal has to "
      "be the one that is nearer to a.",
      "Slerp",
      [](const Quaternion& a, const Quaternion& b, double t) -> Quaternion {
        const double cosine = std::clamp(a.dot(b), -1., 1.);
        return cosine == 1 ? a : arc(a, b, std::acos(cosine), t);
      }},
     {"sign of the angle's cosine only",
      "You have made the angle between a and b small, but you have not changed the sign of b "
      "itself.",
      "Slerp",
      [](const Quaternion& a, const Quaternion& b, double t) -> Quaternion {
        // Exact for small angles too: who makes this mistake may have taken care of those.
        const double angle = 2 * std::atan2((b - a).norm(), (b + a).norm());
        const double acute = std::fmin(angle, pi - angle);
        return acute == 0 ? a : arc(a, b, acute, t);
      }},
     {"straight line, not normalised",
      "Your point is on the chord from a to b, inside the sphere: its length is not 1.", "Slerp",
      [](const Quaternion& a, const Quaternion& b, double t) { return line(a, nearer(a, b), t); }},
     {"straight line, then normalised",
      "Your path is right, your pace is not: it is faster in the middle than at the ends. The "
      "angle has to grow in proportion to t.",
      "Slerp",
      [](const Quaternion& a, const Quaternion& b, double t) -> Quaternion {
        return line(a, nearer(a, b), t).normalized();
      }},
     {"straight line too early",
      "Where a and b are near each other, you replace the arc by a straight line, and they are not "
      "near enough for that: the difference is far above rounding.",
      "What breaks",
      [](const Quaternion& a, const Quaternion& b, double t) -> Quaternion {
        constexpr double near = 0.9995;
        if (std::abs(a.dot(b)) > near) return line(a, nearer(a, b), t).normalized();
        return reference::slerp(a, b, t);
      }},
     {"zero over zero",
      "Where a and b are the same rotation, the angle between them and its sine are 0, and you "
      "divide by it.",
      "What breaks",
      [](const Quaternion& a, const Quaternion& b, double t) -> Quaternion {
        return arc(a, nearer(a, b), std::acos(std::abs(a.dot(b))), t);
      }},
     {"stuck where b is close to a",
      "Where the cosine between a and b is rounded to 1, you return a. They may still be 1e-8 rad "
      "apart: the small step towards b is missing.",
      "What breaks",
      [](const Quaternion& a, const Quaternion& b, double t) {
        return std::abs(a.dot(b)) >= 1 ? a : reference::slerp(a, b, t);
      }},
     {"angle of the turn for the angle between the quaternions",
      "The angle between two quaternions is half the angle of the turn from one to the other. You "
      "have taken the turn's, but on the sphere of quaternions the other one counts.",
      "Slerp",
      [](const Quaternion& a, const Quaternion& b, double t) -> Quaternion {
        const double cosine = std::fmin(std::abs(a.dot(b)), 1);
        return cosine == 1 ? a : arc(a, nearer(a, b), 2 * std::acos(cosine), t);
      }},
     {"a and b swapped", "Your way is right, but t runs from b to a: at t = 0 you must be at a.",
      "Slerp", [](const Quaternion& a, const Quaternion& b, double t) {
        return reference::slerp(b, a, t);
      }}}};
