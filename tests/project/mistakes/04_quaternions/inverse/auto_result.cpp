// expect: wrong | may be named infinite | may be named never set
// The result is an auto expression of a conjugate that is gone.
#include "contract.hpp"

namespace quaternions {

Quaternion inverse(const Quaternion& q) {
  // q q* = |q|²  ⇒  q⁻¹ = q*/|q|²
  const auto result = Quaternion(q[0], -q[1], -q[2], -q[3]) / q.squaredNorm();
  return result;
}

}  // namespace quaternions
