#pragma once
/// @file
/// The twelve edges of a box, as a viewer sees them.

#include <vector>

#include "support/sketch.hpp"

namespace tumble::support {

/// @param edges its columns lead along the edges, from face to face
/// @param view  to the viewer's axes: right, up, towards the viewer
inline std::vector<std::vector<Vec2>> box_edges(const Vec3& centre, const Mat3& edges,
                                                const Mat3& view) {
  const auto corner = [&](int i) -> Vec2 {
    const Vec3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    return (view * (centre + edges * signs / 2)).head<2>();
  };
  std::vector<std::vector<Vec2>> lines;
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if ((i & bit) == 0) lines.push_back({corner(i), corner(i | bit)});
  return lines;
}

}  // namespace tumble::support
