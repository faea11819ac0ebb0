// expect: wrong
// The first factor is overwritten while it is still needed.
#include "contract.hpp"

namespace quaternions {

Quaternion product(const Quaternion& first, const Quaternion& b) {
  Quaternion a = first;
  a[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  // ⟨s, u⟩⟨t, v⟩ = ⟨s t − u·v, s v + t u + u × v⟩
  return {a[0],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}

}  // namespace quaternions
