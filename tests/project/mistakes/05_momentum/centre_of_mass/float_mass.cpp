// expect: wrong | named float | named not a number
// The sum of the masses is a float.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  float mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const PointMass& point : points) {
    mass += point.mass;
    moment += point.mass * point.position;
  }
  // c = Σ m x / Σ m
  return moment / mass;
}

}  // namespace momentum
