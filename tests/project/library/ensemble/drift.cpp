#include "tumble/ensemble/drift.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/relative_error.hpp"

using namespace tumble;
using namespace tumble::detail;
using simd::FourDoubles;
using test::eps;

namespace {

constexpr double drags[] = {0, 1e-300, 1e-12, 1e-3, 0.3, 0.4999, 0.5, 0.5001, 2, 30, 700};

/// φ₁ or φ₂ to more digits than a double has: the quotient where nothing cancels, else the series.
long double phi(int n, long double z) {
  if (std::abs(z) > 1) {
    const long double first = std::expm1(z) / z;
    return n == 1 ? first : (first - 1) / z;
  }
  long double sum = 0, term = n == 1 ? 1 : 0.5L;
  for (int k = 1; k < 30; term *= z / (k + n), ++k) sum += term;
  return sum;
}

}  // namespace

TEST_CASE("decay: e^z, φ₁ and φ₂ to some units in the last place, on both sides of the seam") {
  for (const double size : drags)
    for (const double z : {-size, std::min(size, 5.0)}) {
      CAPTURE(z);
      const auto d = ensembles::decay(FourDoubles{} + z);
      CHECK(test::relative_error(
                d.exp[1], static_cast<double>(std::exp(static_cast<long double>(z)))) <= 4 * eps);
      CHECK(test::relative_error(d.phi1[2], static_cast<double>(phi(1, z))) <= 4 * eps);
      CHECK(test::relative_error(d.phi2[3], static_cast<double>(phi(2, z))) <= 16 * eps);
    }
}

TEST_CASE("decay: every lane by itself") {
  const FourDoubles z{-0.1, -3, NAN, -0.2};
  const auto together = ensembles::decay(z);
  for (const int lane : {0, 1, 3}) {
    const auto alone = ensembles::decay(FourDoubles{} + z[lane]);
    CHECK(together.exp[lane] == alone.exp[0]);
    CHECK(together.phi1[lane] == alone.phi1[0]);
    CHECK(together.phi2[lane] == alone.phi2[0]);
  }
  CHECK(std::isnan(together.phi1[2]));
}

TEST_CASE("drift: falls as v̇ = a − κ v says, for any κ and time") {
  test::Random rng(641);
  for (const double drag : drags)
    for (const double T : {1e-3, 1.0, -1.0}) {
      CAPTURE(drag);
      CAPTURE(T);
      if (-T * drag > 5) continue;
      const double x0 = rng.uniform(), v0 = rng.uniform(), a = rng.uniform();
      simd::Point<FourDoubles> x{FourDoubles{} + x0, {}, {}}, v{FourDoubles{} + v0, {}, {}};
      const ensembles::Push<FourDoubles> push{{FourDoubles{} + a, {}, {}}, FourDoubles{} + drag};
      ensembles::drift<true>(x, v, push, T);
      const long double z = -static_cast<long double>(drag) * T;
      const long double v_end = std::exp(z) * v0 + T * phi(1, z) * a;
      const long double x_end = x0 + T * phi(1, z) * v0 + T * T * phi(2, z) * a;
      const double size =
          std::abs(x0) + std::exp(std::max(0.0, -T * drag)) * (std::abs(v0) + std::abs(a));
      CHECK(std::abs(v.x[0] - static_cast<double>(v_end)) <= 16 * eps * size);
      CHECK(std::abs(x.x[0] - static_cast<double>(x_end)) <= 16 * eps * size);
      CHECK(double{x.y[0]} == 0);
    }
}

TEST_CASE("drift: without drag it is the parabola") {
  simd::Point<FourDoubles> x{FourDoubles{} + 1, {}, {}}, v{FourDoubles{} + 2, {}, {}};
  const ensembles::Push<FourDoubles> fall{{FourDoubles{} - 10, {}, {}}, {}};
  ensembles::drift<false>(x, v, fall, 1.5);
  CHECK(double{x.x[3]} == 1 + 2 * 1.5 - 5 * 2.25);
  CHECK(double{v.x[3]} == 2 - 15);
}
