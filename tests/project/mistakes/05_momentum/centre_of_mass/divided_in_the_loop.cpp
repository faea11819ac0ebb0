// expect: wrong | named not a number
// The sum is divided by the mass after each point.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  double mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const PointMass& point : points) {
    mass += point.mass;
    moment += point.mass * point.position;
    moment /= mass;
  }
  // c = Σ m x / Σ m
  return moment;
}

}  // namespace momentum
