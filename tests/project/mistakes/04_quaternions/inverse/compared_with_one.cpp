// expect: wrong
// Only where the squared length is exactly 1 the conjugate is returned, and else it is divided twice.
#include "contract.hpp"

namespace quaternions {

Quaternion inverse(const Quaternion& q) {
  const Quaternion conjugate(q[0], -q[1], -q[2], -q[3]);
  // q q* = |q|²  ⇒  q⁻¹ = q*/|q|²
  if (q.squaredNorm() == 1) return conjugate;
  return conjugate / q.squaredNorm() / q.squaredNorm();
}

}  // namespace quaternions
