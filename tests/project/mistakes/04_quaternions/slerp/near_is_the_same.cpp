// expect: wrong | named stuck where b is close to a
// Nearer than 1e-4 rad a is returned.
#include <cmath>

#include "contract.hpp"

namespace quaternions {

Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
  // −b is the same orientation; the nearer one is the short way.
  const Quaternion goal = a.dot(b) < 0 ? Quaternion(-b) : b;
  // The angle between them: tan ½Ω = |goal − a| / |goal + a|, as exact near 0 as elsewhere.
  const double angle = 2 * std::atan2((goal - a).norm(), (goal + a).norm());
  if (angle < 1e-4) return a;
  // (sin((1 − t) Ω) a + sin(t Ω) b) / sin Ω
  return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * goal) / std::sin(angle);
}

}  // namespace quaternions
