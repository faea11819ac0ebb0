#include "contract.hpp"

namespace quaternions {

Quaternion inverse(const Quaternion& q) {
  const Quaternion conjugate(q[0], -q[1], -q[2], -q[3]);
  // q q̄ = |q|²  ⇒  q⁻¹ = q̄/|q|²
  return conjugate / q.squaredNorm();
}

}  // namespace quaternions
