// expect: wrong | named not a number
// Masses below 1e-10 kg are skipped.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  double mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const PointMass& point : points) {
    if (point.mass < 1e-10) continue;
    mass += point.mass;
    moment += point.mass * point.position;
  }
  // c = Σ m x / Σ m
  return moment / mass;
}

}  // namespace momentum
