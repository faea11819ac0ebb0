// expect: wrong | named last point left out
// The loop ends one point early.
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points.front(), high = low;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Eigen::Vector3d& point = points[i];
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {(low + high) / 2, Eigen::Matrix3d::Identity(), high - low};
}

}  // namespace bounding_boxes
