#include "tumble/quaternion/convert.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("coefficients: the order is (w, x, y, z)") {
  const Quat q(1, 2, 3, 4);
  CHECK(q.w() == 1);
  CHECK(coefficients(q) == Eigen::Vector4d(1, 2, 3, 4));
  CHECK(from_coefficients(coefficients(q)).coeffs() == q.coeffs());
}

TEST_CASE("to_matrix: a worked number, 120° about the diagonal permutes the axes") {
  const Mat3 R = to_matrix(Quat(0.5, 0.5, 0.5, 0.5));
  CHECK(Vec3(R.col(0)) == Vec3(0, 1, 0));
  CHECK(Vec3(R.col(1)) == Vec3(0, 0, 1));
  CHECK(Vec3(R.col(2)) == Vec3(1, 0, 0));
}

TEST_CASE("to_matrix: turns vectors as q p q⁻¹ does, however long q is") {
  test::Random rng(61);
  for (const Vec3& w : test::rotation_vectors()) {
    const Quat unit = exp_quaternion(w);
    const Vec3 p = rng.vector();
    const Vec3 turned = (unit * Quat(0, p.x(), p.y(), p.z()) * unit.conjugate()).vec();
    for (const double length : {1.0, 1 + 1e-6, 0.5, 1e100, -1.0}) {
      const Mat3 R = to_matrix(Quat(Eigen::Vector4d(length * unit.coeffs())));
      CHECK((R * p - turned).norm() <= 16 * eps * p.norm());
      CHECK(rotation::is_rotation(R, 32 * eps));
    }
  }
}

TEST_CASE("from_matrix: takes back to_matrix in all four branches") {
  int branch_seen[4] = {0, 0, 0, 0};
  for (const Vec3& w : test::rotation_vectors()) {
    const Quat q = exp_quaternion(w);
    const Quat back = from_matrix(to_matrix(q));
    CAPTURE(coefficients(q).transpose());
    CHECK(angle_between(q, back) <= 16 * eps);
    CHECK(std::abs(back.norm() - 1) <= 4 * eps);
    int largest = 0;
    CHECK(coefficients(back).maxCoeff(&largest) > 0);
    ++branch_seen[largest];
  }
  for (const int count : branch_seen) CHECK(count > 10);
}

TEST_CASE(
    "from_matrix: half turns about every axis, where the trace branch alone divides by zero") {
  test::Random rng(62);
  for (int i = 0; i < 100; ++i) {
    const Vec3 u = rng.direction();
    const Mat3 half_turn = 2 * u * u.transpose() - Mat3::Identity();
    const Vec3 v = from_matrix(half_turn).vec();
    CHECK(std::min((v - u).norm(), (v + u).norm()) <= 8 * eps);
  }
}

TEST_CASE("from_matrix: what is no rotation is refused") {
  CHECK_REFUSED(from_matrix(Mat3(Vec3(1, 1, -1).asDiagonal())), "not a rotation", "determinant -1");
  CHECK_REFUSED(from_matrix(Mat3(Mat3::Zero())), "not a rotation", "determinant 0");
  CHECK_REFUSED(from_matrix(Mat3(NAN * Mat3::Identity())), "not a rotation");
}

TEST_CASE("from_axis_angle: is exp of θ u for an axis of any length") {
  test::Random rng(63);
  for (const double length : {1e-200, 1.0, 1e200}) {
    for (int i = 0; i < 50; ++i) {
      const Vec3 u = rng.direction();
      const double angle = rng.uniform(-3, 3);
      const Quat q = from_axis_angle(length * u, angle);
      CHECK((q.coeffs() - exp_quaternion<double>(angle * u).coeffs()).norm() <= 8 * eps);
    }
  }
  CHECK_REFUSED(from_axis_angle(Vec3::Zero(), 1), "the axis (0 0 0) has no direction");
  CHECK_REFUSED(from_axis_angle(Vec3(NAN, 0, 1), 1), "has no direction", "nan");
  CHECK_REFUSED(from_axis_angle(Vec3::UnitX(), INFINITY), "angle", "inf");
}
