/// @file
/// 3.4 gram_schmidt: its laws, and what goes wrong.
#include "tumble/rotation/gram_schmidt.hpp"

#include <cmath>

#include "03_rotation_matrices/contract.hpp"
#include "03_rotation_matrices/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/rotation/nearest_rotation.hpp"
#include "tumble/rotation/orthonormality.hpp"

using namespace tumble::judge;
using tumble::Mat3;
using tumble::Vec3;

namespace student {
const Function<decltype(rotation_matrices::gram_schmidt)> gram_schmidt{TUMBLE_UNIT};
}

namespace {

Mat3 reference(const Mat3& M) { return tumble::rotation::gram_schmidt(M); }

/// What rounding may do to a number of the answer. Taking a column's part along another away leaves
/// an error of some 10 eps of what it was; scaling what is left to length 1 enlarges that, at worst
/// by the condition number. The columns' lengths do not matter, so they are taken out first.
/// Source: Björck, "Solving linear least squares problems by Gram–Schmidt orthogonalization", BIT 7
/// (1967): so much is lost by the modified algorithm, and the square of it by the classical one.
double rounding(const Mat3& M) { return 32 * eps * condition(M.colwise().normalized()); }

/// Columns that lie within about `angle` of one line.
Mat3 almost_parallel(double angle) {
  const Mat3 A = any_rotation(), B = any_rotation();
  return A * Vec3(1, angle, angle).asDiagonal() * B;
}

/// What is left of v without its part along u, if u has length 1.
Vec3 without(const Vec3& v, const Vec3& u) { return v - u.dot(v) * u; }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any drifted matrix: x first, then y, then z") {
    for (int n = 0; n < 30; ++n) {
      const Mat3 M = drifted_rotation(0.4);
      REQUIRE(student::gram_schmidt(M) == close_to(reference(M), rounding(M)));
    }
  }

  TEST_CASE(
      "the first column keeps its direction, the second the plane of the first two, and its side") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 M = drifted_rotation(0.4);
      const auto R = student::gram_schmidt(M);
      const Vec3 x = R->col(0), y = R->col(1), m1 = M.col(0), m2 = M.col(1);
      REQUIRE(R == obeys("x = m₁/|m₁|", (x - m1.normalized()).norm(), rounding(M)));
      const Vec3 normal = m1.cross(m2).normalized();
      REQUIRE(R == obeys("y · (m₁ × m₂) = 0", std::abs(y.dot(normal)), 2 * rounding(M)));
      REQUIRE(R == obeys("y · m₂ > 0", -y.dot(m2), 0));
    }
  }

  TEST_CASE("a rotation comes back as it was") {
    for (const Mat3& R : {Mat3(Mat3::Identity()), Mat3(Vec3(-1, -1, 1).asDiagonal()),
                          any_rotation(), any_rotation()})
      REQUIRE(student::gram_schmidt(R) == close_to(R, rounding(R)));
  }

  TEST_CASE("a rotation times an upper triangular matrix with a positive diagonal comes back") {
    for (int n = 0; n < 20; ++n) {
      Mat3 U = Mat3::Zero();
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < j; ++i) U(i, j) = any_number(-2, 2);
        U(j, j) = any_number(0.5, 2);
      }
      const Mat3 R = any_rotation();
      const Mat3 M = R * U;  // rounded, which counts like the student's own roundings
      REQUIRE(student::gram_schmidt(M) == close_to(R, 2 * rounding(M)));
      REQUIRE(student::gram_schmidt(U) == close_to(Mat3(Mat3::Identity()), rounding(U)));
    }
  }

  TEST_CASE("columns of any length, tiny or huge, give the right rotation: lengths do not matter") {
    for (const Vec3& lengths : {Vec3(2, 3, 5), Vec3(1e-50, 1e-50, 1e-50), Vec3(1e50, 1e50, 1e50),
                                Vec3(1e-50, 1, 1e50), Vec3(1e50, 1, 1e-50)}) {
      const Mat3 M = drifted_rotation(0.4);
      const Mat3 scaled = M * lengths.asDiagonal();
      REQUIRE(student::gram_schmidt(scaled) == close_to(reference(M), 2 * rounding(M)));
    }
  }

  TEST_CASE("after 1000 Euler steps of a steady turn: a rotation again, x first, then y, then z") {
    for (int n = 0; n < 5; ++n) {
      const Mat3 start = any_rotation();
      const Mat3 M = drifted_by_euler(start, 2 * any_direction(), 0.01, 1000);
      const auto R = student::gram_schmidt(M);
      REQUIRE(R == close_to(reference(M), rounding(M)));
      // An error of δ in each number is one of at most 6 δ in RᵀR.
      REQUIRE(R == obeys("RᵀR = 1", tumble::rotation::orthonormality_error(R), 6 * rounding(M)));
    }
  }

  TEST_CASE("columns so close to parallel that the square of their angle is lost in rounding") {
    // After Läuchli (1961): 1 + t² is 1 in a double.
    const double t = 0x1p-27;
    Mat3 M;
    M << 1, 1, 1,  //
        t, 0, 0,   //
        0, t, 0;
    // To the first order in t; what is left out is smaller than eps.
    Mat3 expected;
    expected << Vec3(1, t, 0), Vec3(t, -1, 1) / std::sqrt(2), Vec3(t, -1, -1) / std::sqrt(2);
    REQUIRE(student::gram_schmidt(M) == close_to(expected, rounding(M)));
  }

  TEST_CASE(
      "almost parallel columns: orthogonal, x first, to rounding times the condition number") {
    for (const double angle : {1e-4, 1e-3, 1e-2, 1e-1}) {
      for (int n = 0; n < 10; ++n) {
        const Mat3 M = almost_parallel(angle);
        const auto R = student::gram_schmidt(M);
        REQUIRE(R == close_to(reference(M), rounding(M)));
        REQUIRE(R == obeys("RᵀR = 1", tumble::rotation::orthonormality_error(R), 6 * rounding(M)));
      }
    }
  }
}

const Misconceptions<decltype(rotation_matrices::gram_schmidt)> misconceptions{
    TUMBLE_UNIT,
    {{"columns only normalised",
      "Your columns have length 1 now, but they are not perpendicular: their parts along each "
      "other are still in them.",
      "Gram–Schmidt", [](const Mat3& M) -> Mat3 { return M.colwise().normalized(); }},
     {"not normalised",
      "Your columns are perpendicular, but have kept their lengths. The axes of a body have length "
      "1.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        const Mat3 R = reference(M);
        return R * (R.transpose() * M).diagonal().asDiagonal();
      }},
     {"lengths kept",
      "Your columns are perpendicular, but x and y have kept their lengths, and z = x × y has the "
      "product of both. The axes of a body have length 1.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 R = reference(M);
        R.col(0) = M.col(0);
        R.col(1) *= R.col(1).dot(M.col(1));
        R.col(2) = R.col(0).cross(R.col(1));
        return R;
      }},
     {"rows for columns",
      "You have made the rows perpendicular one after the other, so the first row has kept its "
      "direction. The axes of the body are the columns.",
      "Columns are axes",
      [](const Mat3& M) -> Mat3 { return reference(M.transpose()).transpose(); }},
     {"z first", "You began with the last column, and it has kept its direction. Begin with x.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 { return -reference(-M.rowwise().reverse()).rowwise().reverse(); }},
     {"y first", "You began with the second column, and it has kept its direction. Begin with x.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 other;
        other << M.col(1), M.col(0), -M.col(2);
        const Mat3 Q = reference(other);
        other << Q.col(1), Q.col(0), -Q.col(2);
        return other;
      }},
     {"z before y",
      "You began with x, but then you took z, so that y has to be where it can. After x comes y, "
      "which loses nothing but its part along x.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 other;
        other << M.col(0), M.col(2), -M.col(1);
        const Mat3 Q = reference(other);
        other << Q.col(0), -Q.col(2), Q.col(1);
        return other;
      }},
     {"y left as it was",
      "x and z are right, but y still has a part along x: you have scaled it to length 1 and done "
      "no more.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 R = reference(M);
        R.col(1) = M.col(1).normalized();
        return R;
      }},
     {"projected onto a longer vector",
      "You have taken the part along another column before that column had length 1. Such a part "
      "is wrong by the square of its length.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 R = M;
        R.col(1) = without(M.col(1), R.col(0));
        R.col(2) = without(M.col(2), R.col(0)) - R.col(1).dot(M.col(2)) * R.col(1);
        return R.colwise().normalized();
      }},
     {"x not yet of length 1",
      "You have taken y's part along x before x had length 1. Such a part is wrong by the square "
      "of that length, and z = x × y turns with y.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 R = M;
        R.col(1) = without(M.col(1), R.col(0));
        R.col(2) = R.col(0).cross(R.col(1));
        return R.colwise().normalized();
      }},
     {"z cleaned of x only",
      "z is perpendicular to x, but not to y. It has to lose its parts along both.", "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 R = reference(M);
        R.col(2) = without(M.col(2), R.col(0)).normalized();
        return R;
      }},
     {"left-handed",
      "Your last column points the wrong way, and the matrix is a reflection. With your right "
      "thumb along x and the forefinger along y, the middle finger is z.",
      "Columns are axes",
      [](const Mat3& M) -> Mat3 { return reference(M) * Vec3(1, 1, -1).asDiagonal(); }},
     {"classical, not modified",
      "This is fine where the columns are far from parallel. Here y is not quite perpendicular to "
      "x, and you have taken the part of z along y from the column as it was given, with its large "
      "part along x still in it. Take each part from what the last subtraction has left.",
      "Gram–Schmidt",
      [](const Mat3& M) -> Mat3 {
        Mat3 R = M;
        R.col(0).normalize();
        R.col(1) = without(M.col(1), R.col(0)).normalized();
        R.col(2) = without(M.col(2), R.col(0)) - R.col(1).dot(M.col(2)) * R.col(1);
        R.col(2).normalize();
        return R;
      }},
     {"nearest rotation",
      "This is the rotation nearest to M, and it moves all three columns. Gram and Schmidt leave "
      "the direction of the first.",
      "The nearest rotation", [](const Mat3& M) -> Mat3 { return tumble::nearest_rotation(M); }}}};
