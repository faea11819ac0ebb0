#include "contract.hpp"

namespace when_bodies_meet {

FirstContact first_contact(const GapAt& gap, double speed, double t0, double t1, double tolerance) {
  double t = t0;
  while (t <= t1) {
    const double distance = gap(t);
    if (distance <= tolerance) return {true, t};
    t += distance / speed;
  }
  return {false, 0};
}

}  // namespace when_bodies_meet
