#include "tumble/mass/principal_axes.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble;
using test::eps;
using test::Random;

namespace {

Mat3 rotation(const Vec3& v) {
  return Eigen::AngleAxisd(v.norm(), v.norm() > 0 ? Vec3(v.normalized()) : Vec3(Vec3::UnitX()))
      .toRotationMatrix();
}

}  // namespace

TEST_CASE("principal_axes: a worked number") {
  Mat3 I;
  // clang-format off
  I << 5, 2, 0,
       2, 5, 0,
       0, 0, 1;
  // clang-format on
  const PrincipalAxes axes = principal_axes(I);
  CHECK((axes.moments - Vec3(1, 3, 7)).norm() <= 4 * eps * 7);
  CHECK(std::abs(std::abs(axes.R.col(0).z()) - 1) <= 4 * eps);
  CHECK(std::abs(std::abs(axes.R.col(2).dot(Vec3(1, 1, 0))) - std::sqrt(2)) <=
        4 * eps * (std::sqrt(2)));
}

TEST_CASE("principal_axes: moments ascend, R is a rotation, and I = R diag Rᵀ") {
  Random rng(41);
  for (const Vec3& v : test::rotation_vectors(41)) {
    const Vec3 s(std::pow(10, rng.uniform(-7, 0)), std::pow(10, rng.uniform(-7, 0)), 1);
    const Mat3 R = rotation(v);
    Mat3 I = R * s.asDiagonal() * R.transpose();
    I = ((I + I.transpose()) / 2).eval();
    CAPTURE(I);
    const PrincipalAxes axes = principal_axes(I);
    CHECK(axes.moments[0] <= axes.moments[1]);
    CHECK(axes.moments[1] <= axes.moments[2]);
    // Up to 15 rotations of 2 roundings each multiply into R; it takes no more than 16 eps of them.
    CHECK((axes.R.transpose() * axes.R - Mat3::Identity()).norm() <= 32 * eps);
    CHECK(std::abs(axes.R.determinant() - 1) <= 32 * eps);
    CHECK((axes.R * axes.moments.asDiagonal() * axes.R.transpose() - I).norm() <=
          32 * eps * I.norm());
  }
}

TEST_CASE("principal_axes: what is diagonal already is only put in order") {
  CHECK(principal_axes(Mat3::Identity()).R == Mat3::Identity());
  CHECK(principal_axes(3 * Mat3::Identity()).moments == Vec3(3, 3, 3));
  CHECK(principal_axes(Vec3(1, 2, 3).asDiagonal().toDenseMatrix()).R == Mat3::Identity());
  const PrincipalAxes axes = principal_axes(Vec3(3, 1, 2).asDiagonal().toDenseMatrix());
  CHECK(axes.moments == Vec3(1, 2, 3));
  CHECK(axes.R.determinant() == 1);
  CHECK(axes.R * axes.moments.asDiagonal() * axes.R.transpose() ==
        Vec3(3, 1, 2).asDiagonal().toDenseMatrix());
  CHECK(principal_axes(Mat3::Zero()).moments == Vec3(0, 0, 0));
}

TEST_CASE("principal_axes: a repeated moment is found twice, and its axes are at right angles") {
  for (const Vec3& v : test::rotation_vectors(42)) {
    const Mat3 R = rotation(v);
    for (const Vec3& moments : {Vec3(1, 2, 2), Vec3(1, 1, 2), Vec3(2, 2, 2), Vec3(1e-6, 1, 1)}) {
      const PrincipalAxes axes = principal_axes(R * moments.asDiagonal() * R.transpose());
      CAPTURE(v.transpose());
      CAPTURE(moments.transpose());
      // R I Rᵀ itself is off by up to 18 eps; the moments can move by as much.
      CHECK((axes.moments - moments).norm() <= 32 * eps * moments.norm());
      CHECK((axes.R.transpose() * axes.R - Mat3::Identity()).norm() <= 32 * eps);
    }
  }
}

TEST_CASE("principal_axes: a long thin body along an axis keeps the digits of its small moment") {
  Random rng(43);
  for (int i = 0; i < 200; ++i) {
    // I = D C D with C near 1: what is small is small in rows and columns. Demmel & Veselić: then
    // each moment is good to a few eps times the condition of C, here below 10.
    const Vec3 d(i % 2 == 0 ? 1e-7 : 1e-17, 1, std::pow(10, rng.uniform(-7, 0)));
    const double c = rng.uniform(-0.3, 0.3);
    Mat3 C = Mat3::Identity();
    C(0, 1) = C(1, 0) = c;
    const Mat3 I = d.asDiagonal() * C * d.asDiagonal();
    CAPTURE(I);
    // The smaller root of x² − (p + q) x + p q (1 − c²) in the xy plane, without cancellation.
    const double p = d[0] * d[0], q = d[1] * d[1], half = (p + q) / 2;
    const double product = p * q * (1 - c) * (1 + c);
    const double smallest = product / (half + std::sqrt(half * half - product));
    const double found = principal_axes(I).moments.minCoeff();
    CHECK(std::abs(found - std::min(smallest, d[2] * d[2])) <= 40 * eps * found);
  }
}

TEST_CASE("principal_axes: of tensors as large and as small as double holds") {
  const Mat3 I = rotate_inertia(Quat(0.3, 0.5, -0.7, 0.2).normalized().toRotationMatrix(),
                                Vec3(1, 2, 2.5).asDiagonal());
  for (const double scale : {0x1p-960, 0x1p-600, 0x1p600, 0x1p1000}) {
    CAPTURE(scale);
    const PrincipalAxes found = principal_axes(I * scale);
    CHECK((found.moments / scale - Vec3(1, 2, 2.5)).norm() < 16 * test::eps);
  }
}
