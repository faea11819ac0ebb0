// expect: wrong | named not a number | may be named never set
// The sum was never set to 0.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about) {
  Eigen::Matrix3d I;
  for (const PointMass& point : points) {
    const Eigen::Vector3d r = point.position - about;
    // I = Σ m (rᵀr 1 − r rᵀ)
    I += point.mass * (r.dot(r) * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return I;
}

}  // namespace point_sampling
