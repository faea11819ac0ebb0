#include "tumble/quaternion/quaternion_dot.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/rotation_dot.hpp"

using namespace tumble;
using test::eps;

TEST_CASE("quaternion_dot: a worked number, half the angular velocity") {
  CHECK(coefficients(rotation::quaternion_dot(Quat(1, 0, 0, 0), Vec3(2, 4, 6))) ==
        Eigen::Vector4d(0, 1, 2, 3));
}

TEST_CASE("quaternion_dot: is at right angles to q, so the length does not change") {
  test::Random rng(81);
  for (const Vec3& w : test::rotation_vectors()) {
    const Quat q = exp_quaternion(w);
    const Vec3 omega = rng.vector();
    CHECK(std::abs(q.coeffs().dot(rotation::quaternion_dot(q, omega).coeffs())) <=
          4 * eps * omega.norm());
  }
}

TEST_CASE("quaternion_dot: is the derivative of exp(½ ω t) q, in world and in body coordinates") {
  test::Random rng(82);
  constexpr double h = 1e-5;
  for (int i = 0; i < 50; ++i) {
    const Quat q = exp_quaternion<double>(3 * rng.vector());
    const Vec3 omega = rng.vector();
    const Quat later = exp_quaternion<double>(h * omega) * q,
               earlier = exp_quaternion<double>(-h * omega) * q;
    const Eigen::Vector4d slope = (later.coeffs() - earlier.coeffs()) / (2 * h);
    CHECK((rotation::quaternion_dot(q, omega).coeffs() - slope).norm() <= h * h + 8 * eps / h);
    const Vec3 omega_body = q.conjugate() * omega;
    CHECK((rotation::quaternion_dot_body(q, omega_body).coeffs() - slope).norm() <=
          h * h + 8 * eps / h);
  }
}
