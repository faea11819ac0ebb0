// expect: threw
// The sum starts with the first point, also where there is none.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about) {
  const auto of = [&](const PointMass& point) -> Eigen::Matrix3d {
    const Eigen::Vector3d r = point.position - about;
    return point.mass * (r.dot(r) * Eigen::Matrix3d::Identity() - r * r.transpose());
  };
  Eigen::Matrix3d I = of(points.at(0));
  for (std::size_t n = 1; n < points.size(); ++n) I += of(points[n]);
  return I;
}

}  // namespace point_sampling
