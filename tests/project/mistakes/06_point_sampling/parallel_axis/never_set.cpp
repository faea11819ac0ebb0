// expect: wrong | named not a number | may be named never set
// What is added is one of the three diagonal numbers that was set.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d parallel_axis(const Eigen::Matrix3d& I, double mass, const Eigen::Vector3d& centre,
                              const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  // What all the mass would have in the centre: about the centre itself a body has least.
  const Eigen::Matrix3d before = inertia_of_points({{mass, centre}}, from);
  Eigen::Matrix3d after;
  const Eigen::Vector3d d = centre - to;
  after.diagonal() << d.y() * d.y() + d.z() * d.z(), d.x() * d.x() + d.z() * d.z(),
      d.x() * d.x() + d.y() * d.y();
  after *= mass;
  // I_p = I_centre + m (dᵀd 1 − d dᵀ), d = centre − p: once backwards, once forwards.
  return I - before + after;
}

}  // namespace point_sampling
