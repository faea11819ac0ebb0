#include "tumble/simd/quaternion.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"

using namespace tumble;
using simd::FourDoubles;
using test::eps;

namespace {

/// The same in all lanes but the last, which has another number.
FourDoubles lanes_of(double x) { return FourDoubles{x, x, x, 7}; }
simd::Quaternion<FourDoubles> lanes_of(const Quat& q) {
  return {lanes_of(q.w()), lanes_of(q.x()), lanes_of(q.y()), lanes_of(q.z())};
}
simd::Point<FourDoubles> lanes_of(const Vec3& p) {
  return {lanes_of(p.x()), lanes_of(p.y()), lanes_of(p.z())};
}
Eigen::Vector4d numbers(const simd::Quaternion<FourDoubles>& q) {
  return {q.w[2], q.x[2], q.y[2], q.z[2]};
}
Vec3 numbers(const simd::Point<FourDoubles>& p) { return {p.x[2], p.y[2], p.z[2]}; }

}  // namespace

TEST_CASE("simd quaternions: do in each lane what quaternions do") {
  test::Random rng(71);
  for (int i = 0; i < 100; ++i) {
    const Quat p = exp_quaternion<double>(3 * rng.vector()),
               q = exp_quaternion<double>(3 * rng.vector());
    const Vec3 v = rng.vector();
    CHECK((numbers(lanes_of(p) * lanes_of(q)) - coefficients<double>(p * q)).norm() <= 8 * eps);
    CHECK((numbers(rotate(lanes_of(q), lanes_of(v))) - q * v).norm() <= 16 * eps);
    CHECK((numbers(rotate(conjugate(lanes_of(q)), lanes_of(v))) - q.conjugate() * v).norm() <=
          16 * eps);
    CHECK((numbers(times_vector(lanes_of(q), lanes_of(v))) / 2 -
           coefficients(rotation::quaternion_dot_body(q, v)))
              .norm() <= 8 * eps);
    CHECK((numbers(add_scaled(lanes_of(p), 0.3, lanes_of(q))) -
           (coefficients(p) + 0.3 * coefficients(q)))
              .norm() <= 4 * eps);
  }
}

TEST_CASE("exp_small: is the exponential map to rounding up to 0.6 rad") {
  test::Random rng(72);
  for (const double angle : {0.0, 1e-300, 1e-8, 0.01, 0.3, 0.6}) {
    const Vec3 r = angle * rng.direction();
    CHECK((numbers(simd::exp_small(lanes_of(r))) - coefficients(exp_quaternion(r))).norm() <=
          2 * eps);
  }
  const Vec3 r = rng.direction();  // beyond, (½θ)¹³/13! is missing
  const double error =
      (numbers(simd::exp_small(lanes_of(r))) - coefficients(exp_quaternion(r))).norm();
  CHECK(error <= 2e-14);
  CHECK(error >= 1.8e-14);
}

TEST_CASE("nearly_normalised: takes a length of 1 + δ to 1 − 3/2 δ²") {
  for (const double d : {0.0, 1e-9, -1e-6, 1e-3}) {
    const Quat q(Eigen::Vector4d((1 + d) * exp_quaternion(Vec3(1, 2, 3)).coeffs()));
    const double length = numbers(nearly_normalised(lanes_of(q))).norm();
    CHECK(std::abs(length - (1 - 1.5 * d * d)) <= 4 * eps + std::abs(d * d * d));
  }
}
