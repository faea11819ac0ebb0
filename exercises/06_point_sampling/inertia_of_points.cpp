#include "contract.hpp"

namespace point_sampling {

// 6.1 inertia_of_points: the discrete inertia sum.
// contract.hpp says what to write. Stuck? ./tumble hint 6.1 · Done? ./tumble check 6.1
Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about) {
  throw NotImplemented{};
}

}  // namespace point_sampling
