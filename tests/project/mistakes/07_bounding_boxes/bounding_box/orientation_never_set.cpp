// expect: wrong | named not a number | may be named never set
// R was never set.
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points.front(), high = low;
  for (const Eigen::Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Box box;
  box.centre = (low + high) / 2;
  box.size = high - low;
  return box;
}

}  // namespace bounding_boxes
