#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/crossing_size.hpp"

namespace tumble::detail {

TUMBLE_BODY Eigen::AlignedBox3d box_around(const std::vector<TriangleMeeting>& meetings) {
  Eigen::AlignedBox3d box;
  for (const TriangleMeeting& meeting : meetings) box.extend(meeting.crossing.place);
  const double margin = box.sizes().maxCoeff() / 2;
  return {box.min() - Vec3::Constant(margin), box.max() + Vec3::Constant(margin)};
}

}  // namespace tumble::detail
