#include "contract.hpp"

namespace point_sampling {

// 6.1 inertia_of_points: the discrete inertia sum.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 6.1 · Be judged: ./tumble check 6.1
Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about) {
  throw NotImplemented{};
}

}  // namespace point_sampling
