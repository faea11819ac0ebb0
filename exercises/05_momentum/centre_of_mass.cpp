#include "contract.hpp"

namespace momentum {

// 5.1 centre_of_mass: the point where masses balance.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 5.1 · Be judged: ./tumble check 5.1
Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points) {
  throw NotImplemented{};
}

}  // namespace momentum
