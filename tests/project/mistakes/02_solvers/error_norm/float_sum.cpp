// expect: wrong | named float
// The sum is a float.
#include "contract.hpp"

namespace solvers {

double error_norm(const Eigen::VectorXd& error, const Eigen::VectorXd& y0,
                  const Eigen::VectorXd& y1, const Tolerances& tolerances) {
  if (error.size() == 0) return 0;
  float sum = 0;
  for (Eigen::Index i = 0; i < error.size(); ++i) {
    const double size = std::max(std::abs(y0[i]), std::abs(y1[i]));
    const double allowed = tolerances.absolute + tolerances.relative * size;
    sum += (error[i] / allowed) * (error[i] / allowed);
  }
  // ‖e‖ = √(1/n Σ (eᵢ / allowedᵢ)²)
  return std::sqrt(sum / static_cast<double>(error.size()));
}

}  // namespace solvers
