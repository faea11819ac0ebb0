#pragma once
/// @file
/// The name of a curve in the figure: its box, the leader to it, and how both are drawn.

#include <algorithm>
#include <string>
#include <vector>

#include "support/plot_curve.hpp"

namespace tumble::support::plot_detail {

constexpr double text_height = 15;
constexpr double margin_gap = 7;  // between the frame and a name beside it

/// A rectangle in the figure, y down.
struct Box {
  double x, y, width, height;

  bool holds(const Pixel& p, double around = 0) const {
    return p.x > x - around && p.x < x + width + around && p.y > y - around &&
           p.y < y + height + around;
  }
  bool meets(const Box& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
  }
  Pixel nearest(const Pixel& p) const {
    return {std::clamp(p.x, x, x + width), std::clamp(p.y, y, y + height)};
  }
};

/// A name and what it belongs to.
struct Label {
  std::size_t series;
  Pixel anchor;  ///< the end of the curve
  Box box;

  /// The leader from the curve's end to the name; none if they are beside each other.
  bool has_leader() const { return distance(anchor, box.nearest(anchor)) > 15; }
};

/// The points along a leader, a few pixels from each other.
inline std::vector<Pixel> leader_points(const Label& label) {
  const Pixel a = label.anchor, b = label.box.nearest(a);
  const int n = static_cast<int>(distance(a, b) / 3);
  std::vector<Pixel> points;
  for (int i = 3; i <= n; ++i)
    points.push_back({a.x + (b.x - a.x) * i / n, a.y + (b.y - a.y) * i / n});
  return points;
}

/// The name in its curve's colour, with a rim of paper where it is on the grid.
inline std::string draw_label(const Label& label, const std::string& name,
                              const std::string& colour) {
  std::string svg;
  if (label.has_leader()) {
    const Pixel end = label.box.nearest(label.anchor);
    svg += line(label.anchor.x, label.anchor.y, end.x, end.y,
                stroke_of(colour) + " stroke-width=\"0.8\" opacity=\"0.8\"");
  }
  return svg + text(label.box.x, label.box.y + 12, name,
                    fill_of(colour) + " " + stroke_of("paper") +
                        " stroke-width=\"3\" paint-order=\"stroke\"");
}

}  // namespace tumble::support::plot_detail
