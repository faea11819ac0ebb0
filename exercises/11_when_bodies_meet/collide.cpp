#include "contract.hpp"

namespace when_bodies_meet {

// 11.5 collide: an impact without friction.
// contract.hpp says what to write. Stuck? ./tumble hint 11.5 · Done? ./tumble check 11.5
Eigen::Vector3d collide(const Eigen::Matrix3d& K, const Eigen::Vector3d& u,
                        const Eigen::Vector3d& n, double e) {
  throw NotImplemented{};
}

}  // namespace when_bodies_meet
