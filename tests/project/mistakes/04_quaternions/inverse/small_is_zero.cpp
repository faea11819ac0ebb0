// expect: wrong
// A short quaternion is taken for 0.
#include "contract.hpp"

namespace quaternions {

Quaternion inverse(const Quaternion& q) {
  const Quaternion conjugate(q[0], -q[1], -q[2], -q[3]);
  if (q.squaredNorm() < 1e-12) return Quaternion::Zero();
  // q q* = |q|²  ⇒  q⁻¹ = q*/|q|²
  return conjugate / q.squaredNorm();
}

}  // namespace quaternions
