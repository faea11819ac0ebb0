// expect: wrong | named started at the origin
// The search starts at the origin, which need not be in the box.
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
  for (const Eigen::Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {(low + high) / 2, Eigen::Matrix3d::Identity(), high - low};
}

}  // namespace bounding_boxes
