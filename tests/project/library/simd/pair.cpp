#include "tumble/simd/pair.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/simd/double_double.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::Random;

namespace {

constexpr double eps2 = test::eps * test::eps;

/// A pair of random size with both parts filled.
template <Fma fma>
Pair<double, fma> random_pair(Random& rng) {
  const double hi = std::ldexp(rng.uniform(), static_cast<int>(rng.uniform(-40, 40)));
  return {hi, hi * test::eps * rng.uniform()};
}

template <Fma fma>
simd::DoubleDouble exact(const Pair<double, fma>& x) {
  return simd::DoubleDouble(x.hi) + simd::DoubleDouble(x.lo);
}

/// Sums, differences and products against double-double, whose errors are at most 7 u².
template <Fma fma>
void check_arithmetic() {
  Random rng(23);
  for (int i = 0; i < 1000; ++i) {
    const auto x = random_pair<fma>(rng), y = random_pair<fma>(rng);
    CAPTURE(x.hi);
    CAPTURE(y.hi);
    const double size = std::abs(x.hi) + std::abs(y.hi);
    CHECK(std::abs(double(exact(x + y) - (exact(x) + exact(y)))) <= 8 * eps2 * size);
    CHECK(std::abs(double(exact(x - y) - (exact(x) - exact(y)))) <= 8 * eps2 * size);
    CHECK(std::abs(double(exact(x * y) - exact(x) * exact(y))) <=
          16 * eps2 * std::abs(x.hi * y.hi));
  }
}

}  // namespace

TEST_CASE(
    "pairs: sums, differences and products to some 2⁻¹⁰⁶, with and without fused multiply-add") {
  check_arithmetic<Fma::separate>();
  check_arithmetic<Fma::fused>();
}

TEST_CASE("two_diff, two_prod: what rounding takes is in the second part, bit for bit") {
  Random rng(24);
  for (int i = 0; i < 1000; ++i) {
    const double a = rng.uniform(),
                 b = std::ldexp(rng.uniform(), static_cast<int>(rng.uniform(-60, 60)));
    CAPTURE(a);
    CAPTURE(b);
    const auto difference = two_diff(a, b);
    CHECK(difference.hi == a - b);
    CHECK(exact(difference) == simd::DoubleDouble(a) + simd::DoubleDouble(-b));
    const auto fused = two_prod<Fma::fused>(a, b);
    const auto separate = two_prod<Fma::separate>(a, b);
    CHECK(fused.hi == separate.hi);
    CHECK(fused.lo == separate.lo);
  }
}

TEST_CASE("multiply_add: a b + c, of doubles and of pairs") {
  CHECK(multiply_add<Fma::separate>(3.0, 4.0, 5.0) == 17);
  CHECK(multiply_add<Fma::fused>(3.0, 4.0, 5.0) == 17);
  // 1 − 2⁻¹⁰⁴ is 1 when it is rounded: one rounding, or a pair, keeps what is left of it.
  CHECK(multiply_add<Fma::fused>(1 + 0x1p-52, 1 - 0x1p-52, -1.0) == -0x1p-104);
  const Pair<double> above{1 + 0x1p-52}, below{1 - 0x1p-53}, minus_one{-1.0};
  CHECK(exact(multiply_add<Fma::separate>(above, below, minus_one)) ==
        simd::DoubleDouble(0x1p-53 - 0x1p-105));
}
