#pragma once
/// @file
/// The signs of crossings and of triangles, drawn as lines: words have a rim of paper, which would
/// be a blot on what is filled.

#include <string>

#include "support/sketch.hpp"

namespace point_sampling_chapter {

inline std::string colour_of_sign(bool plus) { return plus ? "c0" : "c1"; }

/// @param half [unit] from the middle to each end
inline void draw_sign(tumble::support::Sketch& sketch, const tumble::support::Vec2& middle,
                      double half, bool plus) {
  using tumble::support::Vec2;
  const tumble::support::Pen pen{colour_of_sign(plus), 2.2};
  const Vec2 across(half, 0), up(0, half);
  sketch.curve({middle - across, middle + across}, pen);
  if (plus) sketch.curve({middle - up, middle + up}, pen);
}

}  // namespace point_sampling_chapter
