/// @file
/// 3.1 euler_angles_to_matrix: its laws, and what goes wrong.
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "03_rotation_matrices/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/rotation/euler_angles.hpp"
#include "tumble/rotation/exp.hpp"
#include "tumble/rotation/orthonormality.hpp"
#include "tumble/rotation/skew.hpp"

using namespace tumble::judge;
using tumble::Mat3;
using tumble::Vec3;

namespace student {
const Function<decltype(rotation_matrices::euler_angles_to_matrix)> euler_angles_to_matrix{
    TUMBLE_UNIT};
}

namespace {

using Axes = std::array<int, 3>;

constexpr double pi = std::numbers::pi;
constexpr Axes xyz{0, 1, 2}, zxz{2, 0, 2};
constexpr std::array<Axes, 12> sequences{{{1, 2, 0},
                                          zxz,
                                          {2, 1, 0},
                                          {1, 2, 1},
                                          {0, 2, 1},
                                          xyz,
                                          {1, 0, 2},
                                          {2, 0, 1},
                                          {0, 1, 0},
                                          {0, 2, 0},
                                          {1, 0, 1},
                                          {2, 1, 2}}};

Mat3 reference(const Vec3& angles, const Axes& axes) {
  return tumble::axis_rotation(axes[0], angles[0]) * tumble::axis_rotation(axes[1], angles[1]) *
         tumble::axis_rotation(axes[2], angles[2]);
}

/// For both sides: six sines and cosines of 2 eps, two matrix products of 3; and an angle that is
/// brought back into one turn first loses the eps of its own size.
double rounding(const Vec3& angles) { return (48 + 2 * angles.lpNorm<1>()) * eps; }

Vec3 any_angles() { return any_vector(pi); }

/// The right matrix of angles of which each has been changed.
auto of_angles(double (*changed)(double)) {
  return [changed](const Vec3& a, const Axes& axes) -> Mat3 {
    return reference(a.unaryExpr(changed), axes);
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any three angles, about the axes of any of the twelve sequences") {
    for (int n = 0; n < 4; ++n) {
      for (const Axes& axes : sequences) {
        const Vec3 angles = any_angles();
        REQUIRE(student::euler_angles_to_matrix(angles, axes) ==
                close_to(reference(angles, axes), rounding(angles)));
      }
    }
  }

  TEST_CASE("a quarter turn about x carries y to z, about y z to x, about z x to y") {
    for (const Axes& axes : sequences) {
      for (int n = 0; n < 3; ++n) {
        const int axis = axes[static_cast<std::size_t>(n)];
        Mat3 quarter;
        quarter.col(axis) = Vec3::Unit(axis);
        quarter.col((axis + 1) % 3) = Vec3::Unit((axis + 2) % 3);
        quarter.col((axis + 2) % 3) = -Vec3::Unit((axis + 1) % 3);
        const Vec3 angles = pi / 2 * Vec3::Unit(n);
        REQUIRE(student::euler_angles_to_matrix(angles, axes) ==
                close_to(quarter, rounding(angles)));
      }
    }
  }

  TEST_CASE("after a quarter turn about z the second turn, about x, is one about the world's y") {
    // A quarter turn about z brings the body's x axis to the world's y axis.
    for (int n = 0; n < 10; ++n) {
      const double beta = any_angles()[0];
      const Vec3 angles(pi / 2, beta, 0);
      const Mat3 expected = tumble::axis_rotation(1, beta) * tumble::axis_rotation(2, pi / 2);
      REQUIRE(student::euler_angles_to_matrix(angles, zxz) == close_to(expected, rounding(angles)));
    }
  }

  TEST_CASE("RᵀR = 1 and det R = 1: it is a rotation") {
    for (const Axes& axes : sequences) {
      const Vec3 angles = any_angles();
      const auto R = student::euler_angles_to_matrix(angles, axes);
      // An error of δ in each number is one of at most 6 δ in RᵀR and 3√3 δ in the determinant.
      REQUIRE(R ==
              obeys("RᵀR = 1", tumble::rotation::orthonormality_error(R), 6 * rounding(angles)));
      REQUIRE(R == obeys("det R = 1", std::abs(R.value().determinant() - 1), 6 * rounding(angles)));
    }
  }

  TEST_CASE("the same turns backwards, in the opposite order, lead back: the product is 1") {
    for (const Axes& axes : sequences) {
      const Vec3 angles = any_angles();
      const auto there = student::euler_angles_to_matrix(angles, axes);
      const auto back =
          student::euler_angles_to_matrix(-angles.reverse(), Axes{axes[2], axes[1], axes[0]});
      const double error = (there.value() * back.value() - Mat3::Identity()).norm();
      REQUIRE(back == obeys("there and back = 1", error, 6 * rounding(angles)));
    }
  }

  TEST_CASE(
      "at gimbal lock the outer angles count as one turn by their sum, before the middle one") {
    for (int n = 0; n < 10; ++n) {
      const Vec3 a = any_angles();
      for (const auto& [beta, axes] : {std::pair(pi / 2, xyz), std::pair(0., zxz)}) {
        const Vec3 angles(a[0], beta, a[2]);
        REQUIRE(student::euler_angles_to_matrix(angles, axes) ==
                close_to(reference({a[0] + a[2], beta, 0}, axes), rounding(angles)));
      }
    }
  }

  TEST_CASE("zero, half turns and angles beyond a full turn, of either sign") {
    for (const Axes& axes : sequences) {
      for (const double size : {0., pi, 1.9 * pi, 7., 100.}) {
        for (const double sign : {1., -1.}) {
          const Vec3 angles = sign * size * Vec3(1, 1, -1);
          REQUIRE(student::euler_angles_to_matrix(angles, axes) ==
                  close_to(reference(angles, axes), rounding(angles)));
        }
      }
    }
  }

  TEST_CASE("tiny turns simply add up, and are not lost") {
    for (const double size : {1e-8, 1e-150}) {
      for (const Axes& axes : sequences) {
        const Vec3 angles = any_vector(size);
        const auto R = student::euler_angles_to_matrix(angles, axes);
        Vec3 sum = Vec3::Zero();
        for (std::size_t n = 0; n < 3; ++n) sum[axes[n]] += angles[static_cast<Eigen::Index>(n)];
        // R = 1 + [sum]× up to products of two angles.
        const double error =
            (tumble::rotation::unskew<double>(R.value()) - sum).lpNorm<Eigen::Infinity>();
        REQUIRE(R == close_to(reference(angles, axes), rounding(angles)));
        REQUIRE(R == obeys("R − Rᵀ = 2 (the sum of the turns) ×", error,
                           3 * size * size + rounding(angles) * size));
      }
    }
  }
}

const Misconceptions<decltype(rotation_matrices::euler_angles_to_matrix)> misconceptions{
    TUMBLE_UNIT,
    {{"fixed axes",
      "You have turned about the world's axes, which stay where they are. Here each turn is about "
      "an axis of the body: look at the order of your three factors.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 {
        return reference(a.reverse(), {axes[2], axes[1], axes[0]});
      }},
     {"turned the other way",
      "Each of your turns goes the wrong way: a positive angle about z takes x towards y. Look at "
      "the place of the minus sign.",
      "Columns are axes",
      [](const Vec3& a, const Axes& axes) -> Mat3 { return reference(-a, axes); }},
     {"transposed",
      "Your matrix maps world → body. Here R maps body → world: its columns are the axes of the "
      "body.",
      "Columns are axes",
      [](const Vec3& a, const Axes& axes) -> Mat3 { return reference(a, axes).transpose(); }},
     {"turn about y mirrored",
      "Your turns about x and z are right, but the one about y goes the wrong way. After y comes "
      "z, then x: a positive angle takes z towards x.",
      "Columns are axes",
      [](const Vec3& a, const Axes& axes) -> Mat3 {
        Vec3 mirrored = a;
        for (std::size_t n = 0; n < 3; ++n)
          if (axes[n] == 1) mirrored[static_cast<Eigen::Index>(n)] *= -1;
        return reference(mirrored, axes);
      }},
     {"degrees for radians",
      "You have converted the angles from degrees. They are in radians already.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 { return reference(pi / 180 * a, axes); }},
     {"radians turned into degrees",
      "You have converted the angles into degrees. Sine and cosine take radians, and the angles "
      "are in radians already.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 { return reference(180 / pi * a, axes); }},
     {"half of each angle",
      "Each turn is by half of its angle. The ½ belongs to quaternions; a matrix has the angle "
      "itself.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 { return reference(a / 2, axes); }},
     {"sine and cosine exchanged",
      "The sine and the cosine are exchanged: a turn by zero is not the identity.",
      "Columns are axes",
      [](const Vec3& a, const Axes& axes) -> Mat3 {
        return reference(Vec3::Constant(pi / 2) - a, axes);
      }},
     {"sine without its sign",
      "The sine of an angle beyond half a turn, or of a negative one, is negative. A root of 1 − "
      "cos² is not.",
      "Columns are axes", of_angles([](double angle) { return std::acos(std::cos(angle)); })},
     {"cosine without its sign",
      "The cosine of an angle beyond a quarter turn is negative. A root of 1 − sin² is not.",
      "Columns are axes", of_angles([](double angle) { return std::asin(std::sin(angle)); })},
     {"angles in the opposite order",
      "The axes come in the right order, and the angles in the opposite one.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 { return reference(a.reverse(), axes); }},
     {"third turn left out", "You have turned about two of the three axes.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 {
        return reference({a[0], a[1], 0}, axes);
      }},
     {"angles picked by axis",
      "You have chosen the angles by the number of the axis. They come in the order of the turns: "
      "the first angle belongs to the first turn, whatever its axis is.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 {
        return reference({a[axes[0]], a[axes[1]], a[axes[2]]}, axes);
      }},
     {"always x y z", "You don't look at the axes: these are turns about x, then y, then z.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes&) -> Mat3 { return reference(a, xyz); }},
     {"always z y x", "You don't look at the axes: these are turns about z, then y, then x.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes&) -> Mat3 {
        return reference(a, {2, 1, 0});
      }},
     {"third axis assumed",
      "You have made the last turn about the axis that was still left. In sequences such as z x z "
      "the first axis comes back.",
      "Euler angles and their order",
      [](const Vec3& a, const Axes& axes) -> Mat3 {
        return reference(a, {axes[0], axes[1], 3 - axes[0] - axes[1]});
      }},
     {"one turn about the sum",
      "You have added the three angles as a vector and taken the sum for a single turn. That is "
      "right for tiny angles only: turns do not commute.",
      "Euler angles and their order", [](const Vec3& a, const Axes& axes) -> Mat3 {
        Vec3 sum = Vec3::Zero();
        for (std::size_t n = 0; n < 3; ++n) sum[axes[n]] += a[static_cast<Eigen::Index>(n)];
        return tumble::exp_rotation(sum);
      }}}};
