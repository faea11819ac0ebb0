// expect: wrong | named whole-number division
// 1/2 is 0.
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points.front(), high = low;
  for (const Eigen::Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {1 / 2 * (low + high), Eigen::Matrix3d::Identity(), high - low};
}

}  // namespace bounding_boxes
