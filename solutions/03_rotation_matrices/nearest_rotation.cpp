#include "contract.hpp"

namespace rotation_matrices {

namespace {

/// X⁻ᵀ = (x₂ × x₃, x₃ × x₁, x₁ × x₂) / det X, where det X = x₁ · (x₂ × x₃).
Eigen::Matrix3d inverse_transpose(const Eigen::Matrix3d& X) {
  Eigen::Matrix3d cofactors;
  cofactors << skew(X.col(1)) * X.col(2), skew(X.col(2)) * X.col(0), skew(X.col(0)) * X.col(1);
  return cofactors / X.col(0).dot(cofactors.col(0));
}

}  // namespace

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M) {
  // Each step squares what is left, so that after a change below this nothing is left.
  constexpr double small_change = 1e-9;
  constexpr int enough = 100;  // a stretch by 1000 takes 15 steps
  Eigen::Matrix3d X = M;
  for (int step = 0; step < enough; ++step) {
    // X ← ½ (X + X⁻ᵀ)  (Higham 1986)
    const Eigen::Matrix3d next = (X + inverse_transpose(X)) / 2;
    const double change = (next - X).norm();
    X = next;
    if (change < small_change) break;
  }
  return X;
}

}  // namespace rotation_matrices
