#pragma once
/// @file
/// Paths in a plane, as SVG: the same scale in both directions.

#include <string>
#include <vector>

#include "02_solvers/problems.hpp"
#include "support/svg.hpp"

namespace tumble::solvers {

/// A window of the plane and where in the figure it is.
struct Window {
  Vec2 low, high;    ///< corners, in the problem's unit
  double left, top;  ///< of the upper left corner [px]
  double scale = 1;  ///< [px per unit]

  Vec2 pixel(const Vec2& p) const {
    return {left + scale * (p[0] - low[0]), top + scale * (high[1] - p[1])};
  }
  bool holds(const Vec2& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
};

using Path = std::vector<Vec2>;

/// The part of a path up to where it leaves the window.
inline std::string draw_path(const Window& window, const Path& path, const std::string& colour,
                             const std::string& attributes = "stroke-width=\"1.6\"") {
  std::string d;
  for (const Vec2& p : path) {
    if (!window.holds(p)) break;
    const Vec2 px = window.pixel(p);
    d += (d.empty() ? "M" : "L") + support::svg_number(px[0]) + " " + support::svg_number(px[1]);
  }
  return "<path d=\"" + d + "\" fill=\"none\" stroke=\"var(--" + colour + ")\" " + attributes +
         "/>\n";
}

inline std::string draw_dots(const Window& window, const Path& path, const std::string& colour,
                             double radius) {
  std::string svg = "<g fill=\"var(--" + colour + ")\">\n";
  for (const Vec2& p : path) {
    if (!window.holds(p)) break;
    const Vec2 px = window.pixel(p);
    svg += "<circle cx=\"" + support::svg_number(px[0]) + "\" cy=\"" + support::svg_number(px[1]) +
           "\" r=\"" + support::svg_number(radius) + "\"/>\n";
  }
  return svg + "</g>\n";
}

/// @param anchor start, middle or end
inline std::string draw_text(const Vec2& px, const std::string& words, const std::string& colour,
                             const std::string& anchor = "start") {
  return "<text x=\"" + support::svg_number(px[0]) + "\" y=\"" + support::svg_number(px[1]) +
         "\" fill=\"var(--" + colour + ")\" font-size=\"17\" text-anchor=\"" + anchor + "\">" +
         support::svg_text(words) + "</text>\n";
}

inline std::string draw_frame(const Window& window) {
  const Vec2 size = window.scale * (window.high - window.low);
  return "<rect x=\"" + support::svg_number(window.left) + "\" y=\"" +
         support::svg_number(window.top) + "\" width=\"" + support::svg_number(size[0]) +
         "\" height=\"" + support::svg_number(size[1]) +
         "\" fill=\"none\" stroke=\"var(--grid)\"/>\n";
}

}  // namespace tumble::solvers
