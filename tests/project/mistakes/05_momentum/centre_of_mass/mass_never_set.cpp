// expect: wrong | may be named never set | may be named not a number
// The sum of the masses was never set to 0.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  double mass;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const PointMass& point : points) {
    mass += point.mass;
    moment += point.mass * point.position;
  }
  // c = Σ m x / Σ m
  return moment / mass;
}

}  // namespace momentum
