#include "contract.hpp"

namespace quaternions {

// 4.7 slerp: the orientation a fraction of the way between two.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 4.7 · Be judged: ./tumble check 4.7
Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
  throw NotImplemented{};
}

}  // namespace quaternions
