#include "tumble/quaternion/normalize.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("normalize: a worked number") {
  CHECK(rotation::normalize(Quat(0, 3, 0, 4)).coeffs() == Quat(0, 0.6, 0, 0.8).coeffs());
}

TEST_CASE("normalize: gives length 1 and keeps the rotation, from 1e-300 to 1e300") {
  for (const Vec3& w : test::rotation_vectors()) {
    const Quat unit = exp_quaternion(w);
    for (const double length : {1e-300, 1 - 1e-8, 1.0, 1 + 1e-8, 1e300}) {
      CAPTURE(length);
      const Quat q = rotation::normalize(Quat(Eigen::Vector4d(length * unit.coeffs())));
      CHECK(std::abs(rotation::norm_drift(q)) <= 4 * eps);
      CHECK((q.coeffs() - unit.coeffs()).norm() <= 4 * eps);
    }
  }
}

TEST_CASE("norm_drift: says how much too long a quaternion is") {
  CHECK(rotation::norm_drift(Quat(1.25, 0, 0, 0)) == 0.25);
}

TEST_CASE("normalize: a quaternion that stands for no rotation is refused") {
  CHECK_REFUSED(rotation::normalize(Quat(0, 0, 0, 0)), "no rotation", "(0 0 0 0)");
  CHECK_REFUSED(rotation::normalize(Quat(1, NAN, 0, 0)), "no rotation", "nan");
  CHECK_REFUSED(rotation::normalize(Quat(1, INFINITY, 0, 0)), "no rotation", "inf");
}
