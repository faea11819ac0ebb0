#include "tumble/ode/linear_solver.hpp"

#include <doctest/doctest.h>

#include <complex>

#include "project/harness/inputs.hpp"

using namespace tumble;
using test::eps;

namespace {

template <class Scalar, int n>
Eigen::Matrix<Scalar, n, n> any_matrix(test::Random& rng) {
  Eigen::Matrix<Scalar, n, n> A;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      A(i, j) = rng.uniform(-1, 1);
      if constexpr (!std::is_same_v<Scalar, double>) A(i, j) += Scalar(0, rng.uniform(-1, 1));
    }
  return A;
}

/// The residual of a solution found with row pivoting is a small multiple of eps |A| |x| (Golub &
/// Van Loan, §3.4.6), whatever the condition of A.
template <class Scalar, int n>
void check_residuals() {
  test::Random rng(95);
  for (int k = 0; k < 50; ++k) {
    const auto A = any_matrix<Scalar, n>(rng);
    const Eigen::Matrix<Scalar, n, 1> b = any_matrix<Scalar, n>(rng).col(0);
    detail::LinearSolver<Eigen::Matrix<Scalar, n, n>> factors;
    factors.compute(A);
    const Eigen::Matrix<Scalar, n, 1> x = factors.solve(b);
    CHECK((A * x - b).norm() <= 16 * n * eps * A.norm() * x.norm());
  }
}

}  // namespace

TEST_CASE("linear solver: small matrices, real and complex, with residuals of rounding") {
  check_residuals<double, 1>();
  check_residuals<double, 3>();
  check_residuals<double, 13>();
  check_residuals<std::complex<double>, 2>();
  check_residuals<std::complex<double>, 13>();
}

TEST_CASE("linear solver: rows are exchanged where the diagonal is zero or tiny") {
  detail::LinearSolver<Mat3> factors;
  factors.compute((Mat3() << 0, 2, 0, 0, 0, 4, 8, 0, 0).finished());
  CHECK(factors.solve(Vec3(2, 4, 8)) == Vec3(1, 1, 1));
  factors.compute((Mat3() << 1e-20, 1, 0, 1, 1, 0, 0, 0, 1).finished());
  CHECK((factors.solve(Vec3(1, 2, 3)) - Vec3(1, 1, 3)).norm() <= 4 * eps);
}

TEST_CASE("linear solver: a singular matrix gives no finite solution") {
  detail::LinearSolver<Mat3> factors;
  factors.compute(Mat3::Zero());
  CHECK_FALSE(factors.solve(Vec3(1, 1, 1)).allFinite());
}
