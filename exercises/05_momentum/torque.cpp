#include "contract.hpp"

namespace momentum {

// 5.3 torque: how strongly a force turns a body.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 5.3 · Be judged: ./tumble check 5.3
Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  throw NotImplemented{};
}

}  // namespace momentum
