#include "tumble/simd/double_double.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::Random;

namespace {

constexpr double u2 = test::eps * test::eps;

/// A double-double of random size with both parts filled.
simd::DoubleDouble random_number(Random& rng) {
  const double hi = std::ldexp(rng.uniform(), static_cast<int>(rng.uniform(-40, 40)));
  return fast_two_sum(hi, hi * test::eps * rng.uniform());
}

double relative(const simd::DoubleDouble& difference, const simd::DoubleDouble& size) {
  return std::abs(double(difference)) / std::abs(double(size));
}

}  // namespace

TEST_CASE("two_sum: nothing is lost, whichever is larger") {
  const simd::DoubleDouble small_first = two_sum(0x1p-60, 1.0), large_first = two_sum(1.0, 0x1p-60);
  CHECK(small_first == simd::DoubleDouble(1, 0x1p-60));
  CHECK(large_first == simd::DoubleDouble(1, 0x1p-60));
  CHECK(simd::DoubleDouble(two_diff(1.0, 0x1p-60)) == simd::DoubleDouble(1, -0x1p-60));
}

TEST_CASE("two_prod: the product of 53-bit numbers has 106 bits, all of them there") {
  const double a = 1 + 0x1p-52, b = 1 - 0x1p-53;
  // (1 + 2⁻⁵²)(1 − 2⁻⁵³) = 1 + 2⁻⁵³ − 2⁻¹⁰⁵
  const simd::DoubleDouble p = two_prod(a, b);
  CHECK(p.hi + p.lo == p.hi);
  CHECK((p.hi - 1) + p.lo == 0x1p-53 - 0x1p-105);
}

TEST_CASE("two_prod: agrees with the fused multiply-add of the standard library to the bit") {
  Random rng(21);
  for (int i = 0; i < 1000; ++i) {
    const double a = rng.uniform(), b = std::ldexp(rng.uniform(), 30);
    CAPTURE(a);
    CAPTURE(b);
    CHECK(simd::DoubleDouble(two_prod(a, b)) ==
          simd::DoubleDouble(a * b, std::fma(a, b, -(a * b))));
  }
}

TEST_CASE(
    "double-double: sums, products and quotients keep the laws of numbers to their error bounds") {
  Random rng(22);
  for (int i = 0; i < 1000; ++i) {
    const simd::DoubleDouble x = random_number(rng), y = random_number(rng), z = random_number(rng);
    CAPTURE(x.hi);
    CAPTURE(y.hi);
    CAPTURE(z.hi);
    // One operation is good to 3 u² (sum), 7 u² (product), 15 u² (quotient): add them
    // along each law.
    const double spread = std::abs(x.hi) + std::abs(y.hi);
    CHECK(std::abs(double((x + y) - y - x)) <= 6 * u2 * (spread + std::abs(y.hi)));
    CHECK(relative(x * y / y - x, x) <= 22 * u2);
    CHECK(relative((x * y) * z - x * (y * z), x * y * z) <= 28 * u2);
    CHECK(std::abs(double(z * (x + y) - (z * x + z * y))) <= 20 * u2 * std::abs(z.hi) * spread);
    CHECK(relative(x * y.hi - x * simd::DoubleDouble(y.hi), x * y) <= 14 * u2);
    CHECK(std::abs(double((x + y.hi) - (x + simd::DoubleDouble(y.hi)))) <= 6 * u2 * spread);
  }
}

TEST_CASE("double-double: keeps what a double loses") {
  simd::DoubleDouble sum;
  for (const double x : {1e16, 1.0, -1e16}) sum += x;
  CHECK(double(sum) == 1);
  const simd::DoubleDouble third = simd::DoubleDouble(1) / simd::DoubleDouble(3);
  CHECK(std::abs(double(third * 3 - simd::DoubleDouble(1))) <= 15 * u2);
  CHECK(third.lo != 0);
  // Where the large parts cancel, both small ones are still there.
  const simd::DoubleDouble rest = simd::DoubleDouble(1, 0x1p-54) + simd::DoubleDouble(-1, 0x1p-120);
  CHECK(rest == simd::DoubleDouble(0x1p-54, 0x1p-120));
  CHECK(simd::DoubleDouble(1, -1e-20) < simd::DoubleDouble(1));
  CHECK_FALSE(simd::DoubleDouble(1) < simd::DoubleDouble(1));
}

TEST_CASE("double-double: fills Eigen's vectors") {
  const Vector3<simd::DoubleDouble> v = Vec3(1, 2, 3).cast<simd::DoubleDouble>();
  CHECK(double(v.dot(v)) == 14);
  CHECK(
      double(v.cross(Vector3<simd::DoubleDouble>(Vec3(0, 0, 1).cast<simd::DoubleDouble>())).x()) ==
      2);
}
