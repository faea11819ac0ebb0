#include "contract.hpp"

namespace when_bodies_meet {

// 11.1 overlapping_pairs: who can meet at all.
// contract.hpp says what to write. Stuck? ./tumble hint 11.1 · Done? ./tumble check 11.1
std::vector<Pair> overlapping_pairs(const std::vector<Bounds>& bounds, const Meet& meet) {
  throw NotImplemented{};
}

}  // namespace when_bodies_meet
