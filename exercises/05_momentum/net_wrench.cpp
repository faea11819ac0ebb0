#include "contract.hpp"

namespace momentum {

// 5.4 net_wrench: all forces on a body, added up.
// contract.hpp says what to write. Stuck? ./tumble hint 5.4 · Done? ./tumble check 5.4
Wrench net_wrench(double mass, const Eigen::Vector3d& x, const Eigen::Matrix3d& R,
                  const Eigen::Vector3d& g, const std::vector<ForceAtBodyPoint>& forces) {
  throw NotImplemented{};
}

}  // namespace momentum
