// expect: wrong | named sign of the angle's cosine only
// Where b is far the angle is turned, but not b.
#include <cmath>

#include "contract.hpp"

namespace quaternions {

Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
  // −b is the same orientation; the nearer one is the short way.
  const Quaternion goal = b;
  // The angle between them: tan ½Ω = |goal − a| / |goal + a|, as exact near 0 as elsewhere.
  double angle = 2 * std::atan2((goal - a).norm(), (goal + a).norm());
  if (a.dot(b) < 0) angle = 3.14159265358979323846 - angle;
  if (angle == 0) return a;
  // (sin((1 − t) Ω) a + sin(t Ω) b) / sin Ω
  return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * goal) / std::sin(angle);
}

}  // namespace quaternions
