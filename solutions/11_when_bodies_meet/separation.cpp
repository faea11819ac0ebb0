#include <cmath>
#include <limits>

#include "contract.hpp"

namespace when_bodies_meet {

Separation separation(const Box& a, const Box& b) {
  const Eigen::Vector3d apart = b.centre - a.centre;
  Separation best{-std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
  const auto look_along = [&](const Eigen::Vector3d& n) {
    const double reach_a = (a.R.transpose() * n).cwiseAbs().dot(a.size) / 2;
    const double reach_b = (b.R.transpose() * n).cwiseAbs().dot(b.size) / 2;
    const double along = n.dot(apart), gap = std::abs(along) - reach_a - reach_b;
    if (gap > best.gap) best = {gap, along < 0 ? Eigen::Vector3d(-n) : n};
  };
  for (int k = 0; k < 3; ++k) {
    look_along(a.R.col(k));
    look_along(b.R.col(k));
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d product = rotation_matrices::skew(a.R.col(i)) * b.R.col(j);
      if (product.norm() > 1e-6) look_along(product.normalized());
    }
  return best;
}

}  // namespace when_bodies_meet
