#pragma once
/// @file
/// A tennis racket as a drawing in lines.

#include <cmath>
#include <numbers>
#include <vector>

#include "objects/tennis_racket.hpp"

namespace tumble::objects {

/// The lines of a racket, in the mesh's coordinates.
struct RacketLines {
  std::vector<std::vector<Vec3>> frame, strings, throat, handle{{{-0.25, 0, 0}, {-0.52, 0, 0}}};
};

inline RacketLines racket_lines() {
  constexpr double degree = std::numbers::pi / 180;
  RacketLines lines;
  lines.frame.emplace_back();
  for (int i = 0; i <= 36; ++i)
    lines.frame[0].emplace_back(head_length * std::cos(10 * i * degree),
                                head_width * std::sin(10 * i * degree), 0);
  for (int i = -3; i <= 3; ++i) {
    const double s = i / 4.0, along = std::sqrt(1 - s * s);
    const double x = head_length, y = head_width;
    lines.strings.push_back({{-x * along, s * y, 0}, {x * along, s * y, 0}});
    lines.strings.push_back({{s * x, -y * along, 0}, {s * x, y * along, 0}});
  }
  for (const double side : {-1., 1.})
    lines.throat.push_back({{-0.135, side * 0.075, 0}, {-0.25, side * 0.006, 0}});
  return lines;
}

}  // namespace tumble::objects
