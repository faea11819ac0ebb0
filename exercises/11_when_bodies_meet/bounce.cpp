#include "contract.hpp"

namespace when_bodies_meet {

// 11.7 bounce: from contact to contact.
// contract.hpp says what to write. Stuck? ./tumble hint 11.7 · Done? ./tumble check 11.7
Bounces bounce(const BallAndFloor& scene, const BallState& start, double t1) {
  throw NotImplemented{};
}

}  // namespace when_bodies_meet
