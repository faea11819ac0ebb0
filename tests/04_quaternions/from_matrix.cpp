/// @file
/// 4.6 from_matrix: its laws, and what goes wrong.
#include <cmath>
#include <numbers>

#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(quaternions::from_matrix)> from_matrix{TUMBLE_UNIT};
}

namespace {

using reference::i, reference::j, reference::k, reference::one;
using std::numbers::pi;

/// The entries of R are off by up to 17 eps. Four times the square of q's largest number m is a sum
/// of four of them, which puts m, at least ½, off by 54/(8 m) ≤ 14 eps, and the other numbers by
/// 35/(4 m) + 28 ≤ 46 eps; room for m down to 0.2, where a division still does no harm.
constexpr double rounding = 128 * eps;

/// A unit quaternion with no number near zero, a turn of at most 2 rad, and an axis with numbers of
/// both signs, so that one answer tells lost signs from a turn the other way round.
Quaternion mild_quaternion() {
  Quaternion q = any_unit_quaternion();
  const auto is_mild = [&q] {
    const auto axis = q.tail<3>().array();
    const bool both_signs = (axis > 0).any() && (axis < 0).any();
    return both_signs && axis.abs().minCoeff() >= 0.2 && std::abs(q[0]) >= 0.55;
  };
  while (!is_mild()) q = any_unit_quaternion();
  return q;
}

/// 4w², 4x², 4y², 4z².
Quaternion squares(const Mat3& R) {
  const double x = R(0, 0), y = R(1, 1), z = R(2, 2);
  return {1 + x + y + z, 1 + x - y - z, 1 - x + y - z, 1 - x - y + z};
}

/// 4w (x, y, z).
Vec3 differences(const Mat3& R) {
  return {R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)};
}

/// By w alone; `divisor` is 4.
Quaternion through_w(const Mat3& R, double divisor) {
  const double w = std::sqrt(squares(R)[0]) / 2;
  const Vec3 v = differences(R) / (divisor * w);
  return {w, v.x(), v.y(), v.z()};
}

/// By x alone.
Quaternion through_x(const Mat3& R) {
  const double x = std::sqrt(squares(R)[1]) / 2, f = 1 / (4 * x);
  return {f * differences(R).x(), x, f * (R(1, 0) + R(0, 1)), f * (R(0, 2) + R(2, 0))};
}

Quaternion roots(const Mat3& R) { return squares(R).cwiseMax(0).cwiseSqrt() / 2; }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("turns of up to 2 rad, about axes that lean to either side") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = mild_quaternion();
      REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
    }
  }

  TEST_CASE("half turns about x, y and z") {
    for (const Quaternion& q : {i, j, k})
      REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
  }

  TEST_CASE("half turns about any axis: the signs of the axis come out right") {
    for (int n = 0; n < 20; ++n) {
      const Vec3 u = any_direction();
      const Quaternion q(0, u.x(), u.y(), u.z());
      REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
    }
    // Two entries of the diagonal are exactly the same here, and neither is larger than the other.
    for (const Vec3& u : {Vec3(1, 1, 0), Vec3(1, 0, 1), Vec3(0, 1, 1), Vec3(1, -1, 0),
                          Vec3(1, 0, -1), Vec3(0, 1, -1)}) {
      const Mat3 R = u * u.transpose() - Mat3::Identity();
      const Vec3 v = u / std::sqrt(2);
      REQUIRE(student::from_matrix(R) ==
              same_rotation(Quaternion(0, v.x(), v.y(), v.z()), rounding));
    }
  }

  TEST_CASE("no turn is 1, and a tiny turn keeps its digits") {
    REQUIRE(student::from_matrix(Mat3::Identity()) == same_rotation(one, rounding));
    for (const double angle : {1e-150, 1e-16, 1e-13, 1e-12, 1e-8, 1e-4}) {
      const Quaternion q = reference::from_axis_angle(any_direction(), angle);
      REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
    }
  }

  TEST_CASE("thirds of a turn about a cube's diagonals: four times ½ or −½, the signs right") {
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        for (const double z : {-0.5, 0.5}) {
          const Quaternion q(0.5, x, y, z);
          REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
        }
  }

  TEST_CASE("any rotation, to rounding") {
    for (int n = 0; n < 50; ++n) {
      const Quaternion q = any_unit_quaternion();
      REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
    }
  }

  TEST_CASE("turns close to π, about the coordinate axes and others") {
    for (const double before : {0.2, 0.1, 0.05, 1e-2, 1e-4, 1e-6, 1e-8, 1e-15})
      for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ()),
                               any_direction(), any_direction()}) {
        const Quaternion q = reference::from_axis_angle(axis, pi - before);
        REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
      }
  }

  TEST_CASE("any of the four numbers may be zero or tiny") {
    for (int which = 0; which < 4; ++which)
      for (const double size : {0., 1e-12, 1e-8, 1e-4}) {
        Quaternion q = any_unit_quaternion();
        q[which] *= size;
        q.normalize();
        REQUIRE(student::from_matrix(reference::to_matrix(q)) == same_rotation(q, rounding));
      }
  }
}

const Misconceptions<decltype(quaternions::from_matrix)> misconceptions{
    TUMBLE_UNIT,
    {{"the rotation backwards",
      "This is the quaternion of Rᵀ. Look at the order in your differences of opposite entries.",
      "From a matrix",
      [](const Mat3& R) { return reference::conjugate(reference::from_matrix(R)); }},
     {"trace only",
      "You have divided everything by w. That is right while w is not small, but at a half turn w "
      "is 0, and close to it few digits are left. Some other number is large then.",
      "From a matrix", [](const Mat3& R) { return through_w(R, 4); }},
     {"two branches for four",
      "Where w is not large, you have taken x for the largest. It may be y or z: a half turn about "
      "y has w = x = 0.",
      "From a matrix",
      [](const Mat3& R) { return R.trace() > 0 ? through_w(R, 4) : through_x(R); }},
     {"signs lost",
      "All your four numbers are positive: a square root has no sign. The entries off the diagonal "
      "know the signs.",
      "From a matrix", [](const Mat3& R) { return roots(R); }},
     {"signs from the differences alone",
      "You take the lengths from four square roots and the signs from the differences of opposite "
      "entries. At a half turn these differences are 0 and know no sign.",
      "From a matrix",
      [](const Mat3& R) {
        const Quaternion q = roots(R);
        const Vec3 d = differences(R);
        return Quaternion(q[0], std::copysign(q[1], d.x()), std::copysign(q[2], d.y()),
                          std::copysign(q[3], d.z()));
      }},
     {"vector part twice too long",
      "Your scalar is right, your vector part is double: the difference of two entries holds 4 w "
      "times a number of q.",
      "From a matrix", [](const Mat3& R) { return through_w(R, 2); }},
     {"scalar stored last",
      "Your numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions",
      [](const Mat3& R) { return reference::store_scalar_last(reference::from_matrix(R)); }}}};
