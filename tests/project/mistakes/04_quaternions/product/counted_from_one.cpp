// expect: crashed
// The components are counted from 1.
#include "contract.hpp"

namespace quaternions {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  // ⟨s, u⟩⟨t, v⟩ = ⟨s t − u·v, s v + t u + u × v⟩
  return {a[1] * b[1] - a[2] * b[2] - a[3] * b[3] - a[4] * b[4],
          a[1] * b[2] + a[2] * b[1] + a[3] * b[4] - a[4] * b[3],
          a[1] * b[3] + a[3] * b[1] + a[4] * b[2] - a[2] * b[4],
          a[1] * b[4] + a[4] * b[1] + a[2] * b[3] - a[3] * b[2]};
}

}  // namespace quaternions
