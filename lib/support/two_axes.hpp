#pragma once
/// @file
/// Two axes in a drawing whose viewer looks along the third one, or nearly.

#include <array>
#include <string>

#include "support/sketch.hpp"

namespace tumble::support {

/// One to the right and one upwards, from the window's origin, with names at their tips.
/// @param length [unit]
inline void draw_two_axes(Sketch& sketch, double length, const std::array<std::string, 2>& names) {
  const Pen pen{"ink", 1.5};
  sketch.arrow({0, 0}, {length, 0}, pen);
  sketch.arrow({0, 0}, {0, length}, pen);
  sketch.words({length, 0}, {8, 5}, names[0]);
  sketch.words({0, length}, {0, -8}, names[1], "ink", "middle");
}

}  // namespace tumble::support
