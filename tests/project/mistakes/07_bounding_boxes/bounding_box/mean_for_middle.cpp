// expect: wrong | named mean of the points
// The centre is the mean of the points.
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points.front(), high = low;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    mean += point / static_cast<double>(points.size());
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {mean, Eigen::Matrix3d::Identity(), high - low};
}

}  // namespace bounding_boxes
