// expect: wrong | named not a number | may be named never set
// The last component was never set.
#include "contract.hpp"

namespace quaternions {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  // ⟨s, u⟩⟨t, v⟩ = ⟨s t − u·v, s v + t u + u × v⟩
  Quaternion c;
  c[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  c[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  c[2] = a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3];
  return c;
}

}  // namespace quaternions
