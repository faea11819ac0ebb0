/// @file
/// 3.5 nearest_rotation: its laws, and what goes wrong.
#include "tumble/rotation/nearest_rotation.hpp"

#include <cmath>

#include "03_rotation_matrices/contract.hpp"
#include "03_rotation_matrices/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/rotation/exp.hpp"
#include "tumble/rotation/gram_schmidt.hpp"
#include "tumble/rotation/newton_rotation.hpp"
#include "tumble/rotation/orthonormality.hpp"

using namespace tumble::judge;
using tumble::Mat3;
using tumble::Vec3;

namespace student {
const Function<decltype(rotation_matrices::nearest_rotation)> nearest_rotation{TUMBLE_UNIT};
}

namespace {

Mat3 reference(const Mat3& M) { return tumble::nearest_rotation(M); }

/// What rounding may do to a number of the answer: some 60 eps, enlarged by the condition number
/// where M is inverted and by its square where the way leads through MᵀM. The root of that by
/// Jacobi's method takes up to 15 turns, each of which is off by some 4 eps.
double rounding(const Mat3& M) { return 64 * eps * condition(M) * condition(M); }

/// The symmetric matrix that stretches along three orthogonal directions.
Mat3 any_stretch(const Vec3& by) {
  const Mat3 directions = any_rotation();
  return directions * by.asDiagonal() * directions.transpose();
}

/// The matrix that shifts along one axis by `amount` times what is along the next one.
Mat3 shear(double amount) {
  Mat3 S = Mat3::Identity();
  S(0, 1) = amount;
  return S;
}

/// A matrix far from every rotation: stretched, flattened or sheared, in random directions.
Mat3 far_from_a_rotation() {
  const Mat3 R = any_rotation(), other = any_rotation();
  const int kind = static_cast<int>(any_number(0, 3));
  if (kind == 0) return R * any_stretch({10, 1, 1});
  if (kind == 1) return R * any_stretch({1, 0.1, any_number(0.5, 2)});
  return R * shear(2) * other;
}

/// The limit, or what becomes of it, of 100 steps.
template <class Step>
Mat3 after_100(Mat3 X, const Step& step) {
  for (int n = 0; n < 100; ++n) X = step(X);
  return X;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any drifted matrix: the rotation that changes it least") {
    for (int n = 0; n < 30; ++n) {
      const Mat3 M = drifted_rotation(0.25);
      REQUIRE(student::nearest_rotation(M) == close_to(reference(M), rounding(M)));
    }
  }

  TEST_CASE("far from a rotation: stretched tenfold, flattened to a tenth, sheared by twice") {
    // In one plane only: the numbers of the axis across it never change.
    for (const int axis : {0, 1, 2}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Mat3 M = Mat3::Identity();
      M(u, v) = any_number(1, 2);
      M(v, v) = any_number(0.3, 0.6);
      REQUIRE(student::nearest_rotation(M) == close_to(reference(M), rounding(M)));
    }
    for (int n = 0; n < 30; ++n) {
      const Mat3 M = far_from_a_rotation();
      REQUIRE(student::nearest_rotation(M) == close_to(reference(M), rounding(M)));
    }
  }

  TEST_CASE("a rotation times a symmetric stretch gives the rotation back, whatever the stretch") {
    for (int n = 0; n < 20; ++n) {
      const double a = any_number(0.2, 4), b = any_number(0.2, 4);
      const Mat3 R = any_rotation(), M = R * any_stretch({a, b, 1});
      // M itself is rounded, which counts like the student's own roundings.
      REQUIRE(student::nearest_rotation(M) == close_to(R, 2 * rounding(M)));
    }
  }

  TEST_CASE("no other rotation is nearer, and what is left is a pure stretch: RᵀM is symmetric") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 M = n % 2 ? far_from_a_rotation() : drifted_rotation(0.25);
      const auto R = student::nearest_rotation(M);
      const Mat3 S = R->transpose() * M;
      REQUIRE(R == obeys("RᵀM = MᵀR", (S - S.transpose()).norm(), 12 * rounding(M) * M.norm()));
      for (const double angle : {1e-3, 0.1, 3.}) {
        const Mat3 other = tumble::exp_rotation<double>(angle * any_direction()) * R.value();
        REQUIRE(R == obeys("‖R − M‖ is the smallest", (R.value() - M).norm() - (other - M).norm(),
                           12 * rounding(M)));
      }
    }
  }

  TEST_CASE(
      "M turned from both sides: the right rotation, turned like M, for no axis is favoured") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 M = drifted_rotation(0.25), A = any_rotation(), B = any_rotation();
      REQUIRE(student::nearest_rotation(A * M * B) ==
              close_to(Mat3(A * reference(M) * B), 2 * rounding(M)));
    }
  }

  TEST_CASE("a rotation comes back as it was, also when it is 1000 times too large or too small") {
    for (const Mat3& R :
         {Mat3(Mat3::Identity()), Mat3(Vec3(1, -1, -1).asDiagonal()), any_rotation()}) {
      for (const double size : {1., 1 + 1e-8, 1e-3, 0.5, 2., 1e3})
        REQUIRE(student::nearest_rotation(size * R) == close_to(R, 2 * rounding(R)));
    }
  }

  TEST_CASE("the smallest drift is repaired too, and by the nearest rotation") {
    for (const double size : {1e-2, 1e-4, 1e-8, 1e-12}) {
      const Mat3 M = drifted_rotation(size);
      const auto R = student::nearest_rotation(M);
      REQUIRE(R == close_to(reference(M), rounding(M)));
      REQUIRE(R == obeys("RᵀR = 1", tumble::rotation::orthonormality_error(R), 6 * rounding(M)));
    }
  }

  TEST_CASE("1000 Euler steps of a steady turn: a rotation again, by 1000 atan(h|ω|) about ω") {
    for (int n = 0; n < 5; ++n) {
      const double h = 0.01;
      const int steps = 1000;
      const Vec3 axis = any_direction(), omega = any_number(1, 3) * axis;
      const Mat3 start = any_rotation();
      const Mat3 M = drifted_by_euler(start, omega, h, steps);
      const auto R = student::nearest_rotation(M);
      REQUIRE(R == close_to(reference(M), rounding(M)));
      // An error of δ in each number is one of at most 6 δ in RᵀR.
      REQUIRE(R == obeys("RᵀR = 1", tumble::rotation::orthonormality_error(R), 6 * rounding(M)));
      // A step turns what is across ω by atan(h|ω|), and stretches it. Each one rounds M anew.
      const double angle = steps * std::atan(h * omega.norm());
      const Mat3 expected = tumble::exp_rotation<double>(angle * axis) * start;
      REQUIRE(R == obeys("turned by 1000 atan(h|ω|)", (R.value() - expected).norm(),
                         4 * steps * eps + 6 * rounding(M)));
    }
  }
}

const Misconceptions<decltype(rotation_matrices::nearest_rotation)> misconceptions{
    TUMBLE_UNIT,
    {{"one Newton step",
      "This is the first step of the iteration. It squares the error, and that is enough for a "
      "small drift but not for a large one: go on until nothing changes.",
      "The nearest rotation",
      [](const Mat3& M) -> Mat3 { return tumble::rotation::newton_rotation_step(M); }},
     {"Gram–Schmidt",
      "This is a rotation, but not the nearest: you have kept the direction of the first column, "
      "and the others pay for it. All three should move alike.",
      "The nearest rotation",
      [](const Mat3& M) -> Mat3 { return tumble::rotation::gram_schmidt(M); }},
     {"Gram–Schmidt by rows",
      "This is a rotation, but not the nearest: you have kept the direction of the first row, and "
      "the others pay for it.",
      "The nearest rotation",
      [](const Mat3& M) -> Mat3 {
        return tumble::rotation::gram_schmidt(M.transpose()).transpose();
      }},
     {"Gram–Schmidt from the last column",
      "This is a rotation, but not the nearest: you have kept the direction of the last column, "
      "and the others pay for it. All three should move alike.",
      "The nearest rotation",
      [](const Mat3& M) -> Mat3 {
        const Mat3 mirrored = -M.rowwise().reverse();
        return -tumble::rotation::gram_schmidt(mirrored).rowwise().reverse();
      }},
     {"columns only normalised",
      "Your columns have length 1 now, but they are not perpendicular. A rotation needs both.",
      "Drift", [](const Mat3& M) -> Mat3 { return M.colwise().normalized(); }},
     {"only the volume repaired",
      "You have divided M by one number, and its determinant is 1. Shear and unequal stretches are "
      "still in it.",
      "Drift", [](const Mat3& M) -> Mat3 { return M / std::cbrt(M.determinant()); }},
     {"inverse not transposed",
      "You have taken the mean with the inverse of X itself, and that iteration forgets the "
      "orientation: look where your cross products are, in columns or in rows.",
      "The nearest rotation",
      [](const Mat3& M) -> Mat3 {
        return after_100(M, [](const Mat3& X) -> Mat3 { return (X + X.inverse()) / 2; });
      }},
     {"not divided by the determinant",
      "You have used the cross products of the columns as they are. They make up the inverse only "
      "when you divide by the volume that the columns span; without it the steps run away.",
      "The nearest rotation",
      [](const Mat3& M) -> Mat3 {
        return after_100(M, [](const Mat3& X) -> Mat3 {
          Mat3 C;
          C << X.col(1).cross(X.col(2)), X.col(2).cross(X.col(0)), X.col(0).cross(X.col(1));
          return (X + C) / 2;
        });
      }},
     {"iteration without an inverse",
      "Steps that use XᵀX in place of an inverse converge only from nearby: they overshoot where M "
      "stretches by more than about √3.",
      "The nearest rotation", [](const Mat3& M) -> Mat3 {
        return after_100(M, [](const Mat3& X) -> Mat3 {
          return X * (3 * Mat3::Identity() - X.transpose() * X) / 2;
        });
      }}}};
