#pragma once
/// @file
/// Rays to the right through an outline in the plane, and what they do at its corners.

#include <algorithm>
#include <utility>
#include <vector>

#include "support/sketch.hpp"

namespace point_sampling_chapter {

using tumble::support::Vec2;

/// Corners of a body that is cut open; anticlockwise, and clockwise around a hole.
using Outline = std::vector<Vec2>;

/// What is done with a ray that passes exactly through what two pieces of the surface share: an
/// edge of two triangles, or a corner of two segments.
enum class EdgeRule { both, none, one };

/// Whether the line of all points at height y meets the segment. A level one counts by no rule.
inline bool meets(const Vec2& a, const Vec2& b, double y, EdgeRule rule) {
  const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
  if (rule == EdgeRule::both) return low <= y && y <= high && low < high;
  if (rule == EdgeRule::none) return low < y && y < high;
  return low <= y && y < high;  // the line is moved up, by less than any number
}

/// Where a ray meets an outline, from left to right: +1 where it leaves.
using Crossings = std::vector<std::pair<double, int>>;

/// Adds those of the ray to the right from p.
inline void add_crossings(Crossings& list, const Outline& outline, const Vec2& p, EdgeRule rule) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (!meets(a, b, p.y(), rule)) continue;
    const double x = a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y());
    const std::pair crossing(x, b.y() > a.y() ? 1 : -1);
    if (x > p.x()) list.insert(std::upper_bound(list.begin(), list.end(), crossing), crossing);
  }
}

inline Outline closed(Outline outline) {
  outline.push_back(outline.front());
  return outline;
}

}  // namespace point_sampling_chapter
