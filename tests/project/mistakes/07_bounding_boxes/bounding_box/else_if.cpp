// expect: wrong
// A coordinate that is a new smallest one is not tried as the largest.
#include "contract.hpp"

namespace bounding_boxes {

Box bounding_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
  for (const Eigen::Vector3d& point : points) {
    for (int i = 0; i < 3; ++i) {
      if (point[i] < low[i])
        low[i] = point[i];
      else if (point[i] > high[i])
        high[i] = point[i];
    }
  }
  return {(low + high) / 2, Eigen::Matrix3d::Identity(), high - low};
}

}  // namespace bounding_boxes
