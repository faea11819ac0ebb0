// expect: wrong
// Where both moments are equal nothing turns.
#include "contract.hpp"

namespace only_what_a_scene_needs {

Quaternion free_symmetric_top(double A, double C, const Quaternion& q0, const Eigen::Vector3d& L,
                              double t) {
  if (L.isZero(0)) return q0;  // nothing turns, and there is no axis to turn about
  if (A == C) return q0;
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d n = quaternions::rotate(q0, z);
  // ω = L/A + (1/C − 1/A)(L·n) n: one turn about L, which stays in the world, and one about n,
  // which stays in the body.
  const double rate = (1 / C - 1 / A) * L.dot(n);
  const Quaternion about_L = quaternions::from_axis_angle(L, t * L.norm() / A);
  const Quaternion about_z = quaternions::from_axis_angle(z, t * rate);
  // q(t) = (turn about L) q₀ (turn about z)
  return quaternions::product(quaternions::product(about_L, q0), about_z);
}

}  // namespace only_what_a_scene_needs
