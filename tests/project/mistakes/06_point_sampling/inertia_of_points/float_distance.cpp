// expect: wrong | named float
// The squared distance is a float.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about) {
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  for (const PointMass& point : points) {
    const Eigen::Vector3d r = point.position - about;
    // I = Σ m (rᵀr 1 − r rᵀ)
    I += point.mass * (static_cast<float>(r.dot(r)) * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return I;
}

}  // namespace point_sampling
