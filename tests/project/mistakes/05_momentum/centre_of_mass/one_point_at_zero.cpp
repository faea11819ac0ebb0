// expect: wrong
// A single point is taken to be at the origin.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  if (points.size() == 1) return Eigen::Vector3d::Zero();
  double mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const PointMass& point : points) {
    mass += point.mass;
    moment += point.mass * point.position;
  }
  // c = Σ m x / Σ m
  return moment / mass;
}

}  // namespace momentum
