#include "tumble/rotation/skew.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"

using namespace tumble;
using test::Random;

TEST_CASE("skew: a worked number") {
  Mat3 expected;
  // clang-format off
  expected << 0, -3,  2,
              3,  0, -1,
             -2,  1,  0;
  // clang-format on
  CHECK(rotation::skew(Vec3(1, 2, 3)) == expected);
}

TEST_CASE("skew: [v]× w is v × w") {
  Random rng(11);
  for (int i = 0; i < 200; ++i) {
    const Vec3 v = rng.vector(), w = rng.vector();
    CAPTURE(v.transpose());
    CAPTURE(w.transpose());
    CHECK((rotation::skew(v) * w - v.cross(w)).norm() <= 4 * test::eps * v.norm() * w.norm());
  }
}

TEST_CASE("unskew: takes back what skew did and ignores the symmetric part") {
  Random rng(12);
  for (int i = 0; i < 200; ++i) {
    const Vec3 v = rng.vector();
    CHECK(rotation::unskew(rotation::skew(v)) == v);
    const Mat3 symmetric = v * v.transpose();
    CHECK((rotation::unskew<double>(rotation::skew(v) + symmetric) - v).norm() <=
          4 * test::eps * (1 + v.norm()));
  }
}
