// expect: wrong | named half the size
// The size holds half of each edge.
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points.front(), high = low;
  for (const Eigen::Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {(low + high) / 2, Eigen::Matrix3d::Identity(), (high - low) / 2};
}

}  // namespace bounding_boxes
