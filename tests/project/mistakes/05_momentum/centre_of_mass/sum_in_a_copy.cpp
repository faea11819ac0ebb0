// expect: wrong
// The sum is made in a copy.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  double mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const PointMass& point : points) {
    mass += point.mass;
    auto add = [moment](const Eigen::Vector3d& more) mutable { moment += more; };
    add(point.mass * point.position);
  }
  // c = Σ m x / Σ m
  return moment / mass;
}

}  // namespace momentum
