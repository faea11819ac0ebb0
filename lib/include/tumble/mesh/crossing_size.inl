#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/crossing_size.hpp"

namespace tumble::detail {

TUMBLE_BODY Eigen::AlignedBox3d box_around(const std::vector<TriangleMeeting>& meetings) {
  Eigen::AlignedBox3d box;
  double deepest = 0;
  for (const TriangleMeeting& meeting : meetings) {
    const TriangleCrossing& crossing = meeting.crossing;
    box.extend(crossing.place - Vec3::Constant(crossing.reach));
    box.extend(crossing.place + Vec3::Constant(crossing.reach));
    deepest = std::max(deepest, crossing.depth);
  }
  const double margin = std::max(box.sizes().maxCoeff() / 2, deepest);
  return {box.min() - Vec3::Constant(margin), box.max() + Vec3::Constant(margin)};
}

}  // namespace tumble::detail
