#include "contract.hpp"

namespace bounding_boxes {

// 7.3 fit_oriented_box: a box that lies along the body.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 7.3 · Be judged: ./tumble check 7.3
Box fit_oriented_box(const std::vector<Eigen::Vector3d>& points) {
  throw NotImplemented{};
}

}  // namespace bounding_boxes
