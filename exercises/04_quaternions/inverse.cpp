#include "contract.hpp"

namespace quaternions {

// 4.2 inverse: the quaternion that undoes another.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 4.2 · Be judged: ./tumble check 4.2
Quaternion inverse(const Quaternion& q) {
  throw NotImplemented{};
}

}  // namespace quaternions
