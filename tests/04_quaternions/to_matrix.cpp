/// @file
/// 4.5 to_matrix: its laws, and what goes wrong.
#include <cmath>
#include <utility>

#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/rotation/orthonormality.hpp"
#include "tumble/rotation/skew.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(quaternions::to_matrix)> to_matrix{TUMBLE_UNIT};
}

namespace {

using reference::i, reference::j, reference::k, reference::one;

/// An entry of the reference takes up to 17 roundings of at most 1, three rotated axes take 22; the
/// sum of both with room for another order.
constexpr double rounding = 64 * eps;

/// Nine entries that are each off by `rounding` make RᵀR and det R off by at most 2·3 of it.
constexpr double rounding_of_all = 6 * rounding;

/// 1 − 2 |v|² and so on, as books have it for unit quaternions: without any division, with
/// `factor` where the 2 belongs.
Mat3 for_unit(const Quaternion& q, double factor) {
  const Mat3 V = tumble::rotation::skew<double>(q.tail<3>());
  return Mat3::Identity() + factor * (q[0] * V + V * V);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any quaternion but zero, of whatever length, has a rotation matrix") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion q = any_quaternion();
      REQUIRE(student::to_matrix(q) == close_to(reference::to_matrix(q), rounding));
    }
  }

  TEST_CASE("1 is the unit matrix, half turns about x, y and z turn two signs") {
    REQUIRE(student::to_matrix(one) == close_to(Mat3(Mat3::Identity()), rounding));
    const auto diagonal = [](double x, double y, double z) -> Mat3 {
      return Vec3(x, y, z).asDiagonal();
    };
    REQUIRE(student::to_matrix(i) == close_to(diagonal(1, -1, -1), rounding));
    REQUIRE(student::to_matrix(j) == close_to(diagonal(-1, 1, -1), rounding));
    REQUIRE(student::to_matrix(k) == close_to(diagonal(-1, -1, 1), rounding));
  }

  TEST_CASE("the columns are the body's axes: 1 + k, of length √2, takes x to y and y to −x") {
    Mat3 about_z;
    about_z << Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ();
    REQUIRE(student::to_matrix(one + k) == close_to(about_z, rounding));
  }

  TEST_CASE("Rᵀ R = 1 and det R = 1, however little or far q has drifted from length 1") {
    for (const double drift :
         {0., 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1., -1e-12, -1e-9, -1e-6, -1e-3, -0.1, -0.9}) {
      const Quaternion q = (1 + drift) * any_unit_quaternion();
      const auto R = student::to_matrix(q);
      REQUIRE(R == obeys("RᵀR = 1", tumble::rotation::orthonormality_error(R), rounding_of_all));
      REQUIRE(R == obeys("det R = 1", std::abs(R->determinant() - 1), rounding_of_all));
    }
  }

  TEST_CASE("the matrix of a b is the product of the matrices of a and b") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion a = any_quaternion(), b = any_quaternion();
      const auto A = student::to_matrix(a), B = student::to_matrix(b);
      const Mat3 AB = A.value() * B.value();
      REQUIRE(student::to_matrix(reference::product(a, b)) == close_to(AB, 6 * rounding));
    }
  }

  TEST_CASE("q and −q, of any length, have the same matrix, and it is the right one") {
    const Quaternion q = any_quaternion();
    REQUIRE(student::to_matrix(-q) == close_to(reference::to_matrix(q), rounding));
  }

  TEST_CASE("a tiny turn by (1, v), hardly longer than 1, has the right digits off the diagonal") {
    for (const double half : {1e-4, 1e-8, 1e-12, 1e-150}) {
      const Vec3 v = half * any_direction();
      const auto R = student::to_matrix(Quaternion(1, v.x(), v.y(), v.z()));
      const Vec3 expected = 2 * v / (1 + v.squaredNorm());
      // The three numbers are as exact, relatively, as those near 1.
      REQUIRE(R == obeys("½ (R − Rᵀ) = sin θ u as a cross product",
                         (tumble::rotation::unskew<double>(R) - expected).norm() / expected.norm(),
                         2 * rounding));
    }
  }

  TEST_CASE("tiny and huge quaternions have the matrices of their rotations") {
    for (const double length : {1e-100, 1e-8, 1e8, 1e100}) {
      const Quaternion q = length * any_unit_quaternion();
      REQUIRE(student::to_matrix(q) == close_to(reference::to_matrix(q), rounding));
    }
  }
}

const Misconceptions<decltype(quaternions::to_matrix)> misconceptions{
    TUMBLE_UNIT,
    {{"transposed",
      "Your matrix takes world axes to body axes. Its columns, not its rows, have to be the body's "
      "axes in the world: look at the signs of the terms with w.",
      "Conventions",
      [](const Quaternion& q) -> Mat3 { return reference::to_matrix(q).transpose(); }},
     {"length ignored",
      "This is right for unit quaternions only. Here q may have drifted, and then the columns of "
      "your matrix have neither length 1 nor right angles between them.",
      "To a matrix", [](const Quaternion& q) { return for_unit(q, 2); }},
     {"scaled by the squared length",
      "Your columns are perpendicular, but as long as |q|²: with w² + x² − y² − z² on the diagonal "
      "the matrix grows with q.",
      "To a matrix",
      [](const Quaternion& q) -> Mat3 { return q.squaredNorm() * reference::to_matrix(q); }},
     {"divided by the length, not its square",
      "Each term is a product of two numbers of q, so it grows with the square of the length.",
      "To a matrix", [](const Quaternion& q) { return for_unit(q, 2 / q.norm()); }},
     {"factor 2 forgotten",
      "Besides the 1, each of your terms is half of what it should be. Try a half turn about z: x "
      "has to go to −x, not to 0.",
      "To a matrix", [](const Quaternion& q) { return for_unit(q, 1 / q.squaredNorm()); }},
     {"signs of one pair swapped",
      "You have swapped the signs of the two entries with w x; the rest is right. Compare with the "
      "turn about x.",
      "To a matrix",
      [](const Quaternion& q) {
        Mat3 R = reference::to_matrix(q);
        std::swap(R(1, 2), R(2, 1));
        return R;
      }},
     {"scalar stored last",
      "Your numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions",
      [](const Quaternion& q) { return reference::to_matrix(reference::read_scalar_last(q)); }}}};
