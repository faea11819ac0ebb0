// expect: wrong | named float
// The scalar part is a float.
#include "contract.hpp"

namespace quaternions {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  // ⟨s, u⟩⟨t, v⟩ = ⟨s t − u·v, s v + t u + u × v⟩
  const float w = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  return {w,
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}

}  // namespace quaternions
