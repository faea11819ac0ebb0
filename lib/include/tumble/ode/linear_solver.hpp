#pragma once
/// @file
/// Solves A x = b for small matrices, and for those of implicit steps, factorised once: Gaussian
/// elimination with row pivoting. Source: Golub & Van Loan, "Matrix Computations", 4th ed. (2013),
/// algorithm 3.4.1.
///
/// For matrices of a fixed, and so small, size this is a few loops. Eigen's PartialPivLU does the
/// same in blocks that pay for large matrices only, and takes seconds to compile for every size and
/// scalar.

#include <Eigen/LU>
#include <cmath>
#include <type_traits>
#include <utility>

namespace tumble::detail {

/// The factors L and U of a matrix with rows exchanged.
template <class Matrix>
class SmallLu {
 public:
  using Scalar = typename Matrix::Scalar;
  using Vector = Eigen::Matrix<Scalar, Matrix::RowsAtCompileTime, 1>;
  static constexpr int n = Matrix::RowsAtCompileTime;

  SmallLu() = default;
  explicit SmallLu(const Matrix& A) { compute(A); }

  void compute(const Matrix& A) {
    lu_ = A;
    for (int k = 0; k < n; ++k) {
      pivot_[k] = row_of_pivot(k);
      for (int j = 0; j < n; ++j) std::swap(lu_(k, j), lu_(pivot_[k], j));
      for (int i = k + 1; i < n; ++i) eliminate(i, k);
    }
  }

  Vector solve(Vector x) const {
    for (int k = 0; k < n; ++k) {
      std::swap(x[k], x[pivot_[k]]);
      for (int j = 0; j < k; ++j) x[k] -= lu_(k, j) * x[j];
    }
    for (int k = n - 1; k >= 0; --k) {
      for (int j = k + 1; j < n; ++j) x[k] -= lu_(k, j) * x[j];
      x[k] /= lu_(k, k);
    }
    return x;
  }

 private:
  int row_of_pivot(int k) const {
    int best = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(lu_(i, k)) > std::abs(lu_(best, k))) best = i;
    return best;
  }

  void eliminate(int i, int k) {
    if (lu_(k, k) == Scalar(0)) return;  // a singular matrix: solve() will divide by this zero
    lu_(i, k) /= lu_(k, k);
    for (int j = k + 1; j < n; ++j) lu_(i, j) -= lu_(i, k) * lu_(k, j);
  }

  Matrix lu_;
  Eigen::Matrix<int, n, 1> pivot_;
};

/// The solver for a matrix type: small where its size is fixed, else in blocks.
template <class Matrix>
using LinearSolver = std::conditional_t<Matrix::RowsAtCompileTime == Eigen::Dynamic,
                                        Eigen::PartialPivLU<Matrix>, SmallLu<Matrix>>;

}  // namespace tumble::detail
