// expect: wrong
// t u is missing: only the first scalar multiplies the other vector.
#include "contract.hpp"

namespace quaternions {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  // ⟨s, u⟩⟨t, v⟩ = ⟨s t − u·v, s v + t u + u × v⟩
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1]};
}

}  // namespace quaternions
