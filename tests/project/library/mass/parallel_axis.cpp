#include "tumble/mass/parallel_axis.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"

using namespace tumble;
using test::eps;
using test::Random;

TEST_CASE("parallel_axis: a worked number: 2 kg, 3 m along x") {
  const Mat3 I = parallel_axis(Mat3::Identity(), 2, Vec3(3, 0, 0));
  CHECK(I == Vec3(1, 19, 19).asDiagonal().toDenseMatrix());
}

TEST_CASE("point_inertia: products have the minus sign") {
  CHECK(point_inertia(2, Vec3(1, 2, 3))(0, 1) == -4);
  CHECK(point_inertia(2, Vec3(1, 2, 3))(0, 0) == 2 * (4 + 9));
}

TEST_CASE(
    "parallel_axis: turns without inertia about the line to the point, and is the same back") {
  Random rng(51);
  for (int i = 0; i < 200; ++i) {
    const Vec3 d = 10 * rng.vector();
    const Mat3 shift = point_inertia(1.5, d);
    CAPTURE(d.transpose());
    CHECK((shift * d).norm() <= 8 * eps * shift.norm() * d.norm());
    CHECK(parallel_axis(Mat3::Zero(), 1.5, d) == parallel_axis(Mat3::Zero(), 1.5, -d));
  }
}

TEST_CASE("parallel_axis: there and back is where it was, up to rounding of the larger number") {
  Random rng(52);
  for (const double distance : {0.0, 1e-8, 1.0, 1e3}) {
    for (int i = 0; i < 50; ++i) {
      const Mat3 I = Vec3(2, 3, 4).asDiagonal();
      const Vec3 d = distance * rng.direction();
      const Mat3 there = parallel_axis(I, 2, d);
      CAPTURE(distance);
      CHECK((inertia_about_centre(there, 2, d) - I).norm() <= 2 * eps * there.norm());
    }
  }
}

TEST_CASE("inertia_about: of all points the centre of mass has the least") {
  Random rng(53);
  const MassProperties body{2, Vec3(1, -2, 3), Vec3(2, 3, 4).asDiagonal()};
  CHECK(inertia_about(body, body.centre) == body.inertia);
  CHECK(inertia_about(body, Vec3(1, -2, 0)) == Vec3(20, 21, 4).asDiagonal().toDenseMatrix());
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = rng.direction();
    const Mat3 I = inertia_about(body, 5 * rng.vector());
    CHECK(axis.dot(I * axis) >= axis.dot(body.inertia * axis) * (1 - 8 * eps));
  }
}
