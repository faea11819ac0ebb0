// expect: wrong
// The sums are static and go on in the next call.
#include "contract.hpp"

namespace momentum {

Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  static double mass = 0;
  static Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const PointMass& point : points) {
    mass += point.mass;
    moment += point.mass * point.position;
  }
  // c = Σ m x / Σ m
  return moment / mass;
}

}  // namespace momentum
