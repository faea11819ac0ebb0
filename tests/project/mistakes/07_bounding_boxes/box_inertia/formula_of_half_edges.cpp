// expect: wrong | named a third for a twelfth
// The formula is that of half edges.
#include "contract.hpp"

namespace bounding_boxes {

Eigen::Matrix3d box_inertia(double mass, const Box& box, const Eigen::Vector3d& about) {
  const Eigen::Vector3d squares = box.size.cwiseProduct(box.size);
  // In the box's own axes, edges a, b, c: I = m/12 diag(b² + c², c² + a², a² + b²)
  const Eigen::Vector3d moments = mass / 3 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  const Eigen::Matrix3d I_box = moments.asDiagonal();
  // Turned into world axes, then moved from the centre to the point.
  const Eigen::Matrix3d I = point_sampling::rotate_inertia(box.R, I_box);
  return point_sampling::parallel_axis(I, mass, box.centre, box.centre, about);
}

}  // namespace bounding_boxes
