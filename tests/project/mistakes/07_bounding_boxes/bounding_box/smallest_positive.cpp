// expect: wrong | named smallest positive double for the lowest
// The largest coordinate starts at the smallest positive double.
#include <limits>
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points.front(), high = Eigen::Vector3d::Constant(std::numeric_limits<double>::min());
  for (const Eigen::Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {(low + high) / 2, Eigen::Matrix3d::Identity(), high - low};
}

}  // namespace bounding_boxes
