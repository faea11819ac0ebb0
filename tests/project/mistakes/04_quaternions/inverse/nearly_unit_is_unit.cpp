// expect: wrong
// Near length 1 the conjugate is taken for the inverse.
#include "contract.hpp"

namespace quaternions {

Quaternion inverse(const Quaternion& q) {
  const Quaternion conjugate(q[0], -q[1], -q[2], -q[3]);
  if (std::abs(q.norm() - 1) < 1e-3) return conjugate;
  // q q* = |q|²  ⇒  q⁻¹ = q*/|q|²
  return conjugate / q.squaredNorm();
}

}  // namespace quaternions
