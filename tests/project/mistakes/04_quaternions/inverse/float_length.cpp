// expect: wrong | named float | named infinite
// The squared length is a float, which overflows.
#include "contract.hpp"

namespace quaternions {

Quaternion inverse(const Quaternion& q) {
  const Quaternion conjugate(q[0], -q[1], -q[2], -q[3]);
  const float length = q.squaredNorm();
  // q q* = |q|²  ⇒  q⁻¹ = q*/|q|²
  return conjugate / length;
}

}  // namespace quaternions
