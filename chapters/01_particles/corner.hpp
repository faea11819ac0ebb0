#pragma once
/// @file
/// The axes of a drawing, in a corner of it.

#include <string>

#include "support/sketch.hpp"

namespace particles_chapter {

using tumble::support::Sketch;
using tumble::support::Vec2;

/// Two arrows along the axes of the drawing.
inline void draw_corner(Sketch& sketch, const Vec2& corner, double length, const std::string& right,
                        const std::string& up) {
  sketch.arrow(corner, corner + Vec2(length, 0), {"faint", 1.5});
  sketch.arrow(corner, corner + Vec2(0, length), {"faint", 1.5});
  sketch.words(corner + Vec2(length, 0), {6, 5}, right);
  sketch.words(corner + Vec2(0, length), {-4, -6}, up);
}

}  // namespace particles_chapter
