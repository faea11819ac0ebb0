#pragma once
/// @file
/// The rod and the floor that it meets, drawn.

#include <cmath>

#include "support/sketch.hpp"

namespace contact_chapter {

/// A rod of 2 m as a thick line with its centre, its left end at the origin.
/// @param angle to the floor [rad]
inline void draw_rod(tumble::support::Sketch& sketch, double angle) {
  const tumble::support::Vec2 along(std::cos(angle), std::sin(angle));
  sketch.curve({{0, 0}, 2 * along}, {"solid", 9});
  sketch.dot(along, "ink", 4);
}

inline void draw_floor(tumble::support::Sketch& sketch, double left, double right) {
  sketch.curve({{left, 0}, {right, 0}}, {"ink", 1.8});
  for (double x = left; x < right; x += 0.1)
    sketch.curve({{x, -0.07}, {x + 0.06, 0}}, {"faint", 1.2});
}

}  // namespace contact_chapter
