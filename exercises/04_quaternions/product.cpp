#include "contract.hpp"

namespace quaternions {

// 4.1 product: the product of two quaternions.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 4.1 · Be judged: ./tumble check 4.1
Quaternion product(const Quaternion& a, const Quaternion& b) {
  throw NotImplemented{};
}

}  // namespace quaternions
