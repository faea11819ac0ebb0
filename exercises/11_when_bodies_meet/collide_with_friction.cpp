#include "contract.hpp"

namespace when_bodies_meet {

// 11.6 collide_with_friction: an impact that never creates energy.
// contract.hpp says what to write. Stuck? ./tumble hint 11.6 · Done? ./tumble check 11.6
PlanarImpulse collide_with_friction(const Eigen::Matrix2d& K, const Eigen::Vector2d& u, double e,
                                    double mu) {
  throw NotImplemented{};
}

}  // namespace when_bodies_meet
