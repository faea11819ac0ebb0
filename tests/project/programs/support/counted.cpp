#include "support/counted.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

using namespace tumble::support;

namespace {

using Vector = Eigen::Matrix<Counted, 3, 1>;

const Vector a(1, 2, 3), b(4, 5, 6);

}  // namespace

TEST_CASE("counted: the products of vectors cost what one counts by hand") {
  Counted dot;
  Operations done = count([&] { dot = a.dot(b); });
  CHECK(dot.value == 32);
  CHECK(done.multiplications == 3);
  CHECK(done.additions == 2);
  Vector cross;
  done = count([&] { cross = a.cross(b); });
  CHECK(cross[0].value == -3);
  CHECK(done.multiplications == 6);
  CHECK(done.additions == 3);
}

TEST_CASE("counted: divisions count as multiplications, roots as functions, signs as nothing") {
  const Operations done = count([] {
    Counted x = 4;
    x /= 2;
    x = -x;
    x = sqrt(x * x) - 1;
  });
  CHECK(done.multiplications == 2);
  CHECK(done.additions == 1);
  CHECK(done.functions == 1);
}
