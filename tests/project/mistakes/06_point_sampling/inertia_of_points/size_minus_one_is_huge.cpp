// expect: crashed
// The loop ends at size() - 1, which is huge if there are none.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about) {
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n <= points.size() - 1; ++n) {
    const PointMass& point = points[n];
    const Eigen::Vector3d r = point.position - about;
    // I = Σ m (rᵀr 1 − r rᵀ)
    I += point.mass * (r.dot(r) * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return I;
}

}  // namespace point_sampling
