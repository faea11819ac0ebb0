// expect: wrong
// For a light body nothing is done.
#include "contract.hpp"

namespace point_sampling {

Eigen::Matrix3d parallel_axis(const Eigen::Matrix3d& I, double mass, const Eigen::Vector3d& centre,
                              const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  if (mass < 1e-9) return I;
  // What all the mass would have in the centre: about the centre itself a body has least.
  const Eigen::Matrix3d before = inertia_of_points({{mass, centre}}, from);
  const Eigen::Matrix3d after = inertia_of_points({{mass, centre}}, to);
  // I_p = I_centre + m (dᵀd 1 − d dᵀ), d = centre − p: once backwards, once forwards.
  return I - before + after;
}

}  // namespace point_sampling
