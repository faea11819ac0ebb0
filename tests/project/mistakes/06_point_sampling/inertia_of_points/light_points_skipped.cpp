// expect: wrong
// Masses below 1e-12 kg are skipped.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about) {
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  for (const PointMass& point : points) {
    if (point.mass < 1e-12) continue;
    const Eigen::Vector3d r = point.position - about;
    // I = Σ m (rᵀr 1 − r rᵀ)
    I += point.mass * (r.dot(r) * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return I;
}

}  // namespace point_sampling
