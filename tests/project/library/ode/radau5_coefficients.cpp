#include "tumble/ode/radau5_coefficients.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace tumble;
using namespace tumble::detail;

namespace {

using Real = long double;
using C = Radau5Coefficients<Real>;
using Matrix = Matrix3<Real>;

/// Hairer & Wanner II, table IV.5.6.
Matrix A() {
  const Real r = C::root6;
  Matrix A;
  A << (88 - 7 * r) / 360, (296 - 169 * r) / 1800, (-2 + 3 * r) / 225, (296 + 169 * r) / 1800,
      (88 + 7 * r) / 360, (-2 - 3 * r) / 225, (16 - r) / 36, (16 + r) / 36, Real(1) / 9;
  return A;
}

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

}  // namespace

TEST_CASE("Radau5Coefficients: A = T Λ⁻¹ T⁻¹") {
  Matrix Lambda;
  Lambda << C::gamma, 0, 0, 0, C::alpha, -C::beta, 0, C::beta, C::alpha;
  // Numbers up to 5, three products of three terms.
  CHECK((C::T() * C::T_inverse() - Matrix::Identity()).norm() <= 45 * epsilon);
  CHECK((A() * C::T() * Lambda - C::T()).norm() <= 45 * epsilon);
}

TEST_CASE("Radau5Coefficients: integrates polynomials up to degree 4, the stages up to 2") {
  const Vector3<Real> c = C::c();
  for (int k = 1; k <= 5; ++k) {
    CAPTURE(k);
    const Vector3<Real> powers(std::pow(c[0], k - 1), std::pow(c[1], k - 1), 1);
    const Vector3<Real> sums = A() * powers;
    CHECK(std::abs(sums[2] - Real(1) / static_cast<Real>(k)) <= 8 * epsilon);
    if (k > 3) continue;
    for (int i = 0; i < 3; ++i)
      CHECK(std::abs(sums[i] - std::pow(c[i], k) / static_cast<Real>(k)) <= 8 * epsilon);
  }
}

TEST_CASE("Radau5Coefficients: the interpolation goes through the stages and through 0") {
  for (int i = 0; i < 3; ++i) {
    CAPTURE(i);
    const Vector3<Real> weights = C::interpolation_weights(C::c()[i]);
    CHECK((weights - Vector3<Real>::Unit(i)).norm() <= 32 * epsilon);
  }
  CHECK(C::interpolation_weights(0).norm() == 0);
}

TEST_CASE(
    "Radau5Coefficients: the error estimate sees nothing in f constant, linear or quadratic") {
  // f(t, y) + Σ eᵢ Zᵢ/h with Zᵢ = h cᵢᵏ/k must vanish for f = τ^(k−1), k = 1, 2, 3.
  for (int k = 1; k <= 3; ++k) {
    CAPTURE(k);
    Real sum = k == 1 ? 1 : 0;
    for (int i = 0; i < 3; ++i) sum += C::e()[i] * std::pow(C::c()[i], k) / static_cast<Real>(k);
    CHECK(std::abs(sum) <= 45 * epsilon);
  }
}
