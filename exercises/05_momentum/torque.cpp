#include "contract.hpp"

namespace momentum {

// 5.3 torque: how strongly a force turns a body.
// contract.hpp says what to write. Stuck? ./tumble hint 5.3 · Done? ./tumble check 5.3
Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x) {
  throw NotImplemented{};
}

}  // namespace momentum
