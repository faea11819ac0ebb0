#pragma once
/// @file
/// A cube, and the same cube with one vertex more.

#include "common.hpp"

namespace bounding_boxes_chapter {

inline Points cube_corners() {
  Points points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5);
  return points;
}

/// The vertex in the middle of an edge changes nothing in the shape.
inline Points cube_with_a_vertex() {
  Points points = cube_corners();
  points.emplace_back(0.5, 0.5, 0);
  return points;
}

}  // namespace bounding_boxes_chapter
