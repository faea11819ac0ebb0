#pragma once
/// @file
/// What a place for the name of a curve costs: by itself, and beside another name.

#include <algorithm>
#include <cmath>

#include "support/plot_label.hpp"

namespace tumble::support::plot_detail {

inline bool fits(const Box& box, const Frame& frame) {
  constexpr double wide = 1.2;  // some fonts are so much wider than text_width() says
  return box.x > left + 3 && box.x + wide * box.width < width - 2 && box.y > top - 8 &&
         box.y + box.height < frame.floor() + 6;
}

inline bool stands_on_axis(const Box& box, const Frame& frame) {
  constexpr double near = 2;
  return box.x < frame.right_end() && box.y < frame.floor() + near &&
         box.y + box.height > frame.floor() - near;
}

/// In pixels of leader, roughly: what it costs to be far away or outside.
inline double cost_by_itself(const Label& label, const Frame& frame) {
  double cost = distance(label.anchor, label.box.nearest(label.anchor));
  if (label.has_leader()) cost += 8;
  if (!fits(label.box, frame)) cost += 1e4;
  if (stands_on_axis(label.box, frame)) cost += 200;
  return cost;
}

/// What a curve covers beside its points, its markers with it where each point has one.
inline double half_width(const Series& series) {
  const bool marked = series.look == Look::dots || series.x.size() <= most_markers;
  return marked ? 5 : 3;
}

/// Whether the leader of one name runs through the other.
inline double crossings(const Label& from, const Label& through) {
  const Pixel a = from.anchor, b = from.box.nearest(a);
  const Box around{std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x),
                   std::abs(a.y - b.y)};
  if (!around.meets(through.box) || !from.has_leader()) return 0;
  for (const Pixel& p : leader_points(from))
    if (through.box.holds(p)) return 1;
  return 0;
}

/// Whether two names are one above the other, and the ends of their curves the other way round.
inline bool are_swapped(const Label& a, const Label& b) {
  constexpr double beside = 30;  // pixels between ends that one takes for one above the other
  const bool stacked = a.box.x < b.box.x + b.box.width && b.box.x < a.box.x + a.box.width;
  const bool near = std::abs(a.anchor.x - b.anchor.x) < beside;
  return stacked && near && (a.anchor.y - b.anchor.y) * (a.box.y - b.box.y) < 0;
}

}  // namespace tumble::support::plot_detail
