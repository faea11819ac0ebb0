#pragma once
/// @file
/// A part of a plane in a drawing, and paths in it.

#include <algorithm>
#include <vector>

#include "support/sketch.hpp"

namespace solvers_chapter {

namespace support = tumble::support;
using support::Vec2;

using Path = std::vector<Vec2>;

/// A part of the plane, and where in the figure its upper left corner is.
struct Cutout {
  Vec2 low, high;    ///< corners, in the problem's unit
  double left, top;  ///< [px]
  double scale;      ///< [px per unit]

  support::Window window() const { return {left - scale * low[0], top + scale * high[1], scale}; }

  /// The path up to where it leaves the cutout.
  Path within(const Path& path) const {
    const auto inside = [this](const Vec2& p) {
      return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
    };
    return {path.begin(), std::find_if_not(path.begin(), path.end(), inside)};
  }
};

/// Looks at the cutout from now on, and draws its border.
inline void look_at(support::Sketch& sketch, const Cutout& cutout) {
  sketch.look(cutout.window());
  sketch.frame(cutout.low, cutout.high, {"grid", 1});
}

}  // namespace solvers_chapter
