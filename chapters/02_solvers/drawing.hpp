#pragma once
/// @file
/// Paths in a plane, cut off where they leave the drawing.

#include <algorithm>
#include <vector>

#include "problems.hpp"
#include "support/sketch.hpp"

namespace solvers_chapter {

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

/// The places after all the steps of an integration, and the lengths of the steps.
struct Track {
  Path places;
  std::vector<double> times, steps;

  void operator()(double t, const Vec4& y) {
    steps.push_back(t - (times.empty() ? 0 : times.back()));
    times.push_back(t);
    places.push_back(y.head<2>());
  }
  double shortest() const { return *std::min_element(steps.begin(), steps.end()); }
  double longest() const { return *std::max_element(steps.begin(), steps.end()); }
};

}  // namespace solvers_chapter
