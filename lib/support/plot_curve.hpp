#pragma once
/// @file
/// One curve of a plot: its line and its markers.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "support/plot_frame.hpp"
#include "support/series_looks.hpp"
#include "support/svg_path.hpp"

namespace tumble::support::plot_detail {

constexpr std::size_t most_markers = 40;  // a curve with more points has a few markers on its way

struct Pixel {
  double x, y;
};

inline double distance(const Pixel& a, const Pixel& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// What of a curve can be shown, as the pieces between the points that can't.
inline std::vector<std::vector<Pixel>> pieces(const Series& series, const Frame& frame) {
  std::vector<std::vector<Pixel>> list;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!frame.shows(series.x[i], series.y[i])) {
      pen_down = false;
      continue;
    }
    if (!pen_down) list.emplace_back();
    pen_down = true;
    list.back().push_back({frame.px(series.x[i]), frame.py(series.y[i])});
  }
  return list;
}

inline std::string at(const Pixel& p) { return svg_number(p.x) + " " + svg_number(p.y); }

/// The outline of a marker about a point, as part of a path: circle, square, triangle up, diamond,
/// triangle down.
inline std::string outline(int shape, const Pixel& p) {
  switch (shape) {
    case 0:
      return "M" + at({p.x - 3.2, p.y}) + "a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0z";
    case 1:
      return "M" + at({p.x - 3, p.y - 3}) + "h6v6h-6z";
    case 2:
      return "M" + at({p.x, p.y - 4.2}) + "l3.8 6.6h-7.6z";
    case 3:
      return "M" + at({p.x, p.y - 4.4}) + "l4.4 4.4l-4.4 4.4l-4.4 -4.4z";
    default:
      return "M" + at({p.x, p.y + 4.2}) + "l3.8 -6.6h-7.6z";
  }
}

inline std::string draw_markers(const std::vector<Pixel>& points, const SeriesLook& look) {
  if (points.empty()) return "";
  std::string path;
  for (const Pixel& p : points) path += outline(look.marker % marker_shapes, p);
  const bool open = look.marker >= marker_shapes;
  return "<path class=\"marks\" d=\"" + path + "\" " + fill_of(open ? "paper" : look.colour) + " " +
         stroke_of(look.colour) + " stroke-width=\"1.4\"/>\n";
}

inline double length(const std::vector<std::vector<Pixel>>& curve) {
  double sum = 0;
  for (const std::vector<Pixel>& piece : curve)
    for (std::size_t i = 1; i < piece.size(); ++i) sum += distance(piece[i - 1], piece[i]);
  return sum;
}

/// A few places on a long curve. Each curve of a plot starts at another one, so that the markers of
/// two curves that run together are side by side.
/// @param phase which part of the way between two markers comes before the first
inline std::vector<Pixel> places_along(const std::vector<std::vector<Pixel>>& curve, double phase) {
  constexpr double near = 110, most = 7;
  const double spacing = std::max(near, length(curve) / most);
  std::vector<Pixel> places;
  double next = phase * spacing, passed = 0;
  for (const std::vector<Pixel>& piece : curve)
    for (std::size_t i = 1; i < piece.size(); ++i) {
      passed += distance(piece[i - 1], piece[i]);
      if (passed < next) continue;
      places.push_back(piece[i]);
      next += spacing;
    }
  return places;
}

inline std::string draw_line(const std::vector<std::vector<Pixel>>& curve, const Series& series,
                             const std::string& colour) {
  SvgPath path;
  for (const std::vector<Pixel>& piece : curve)
    for (std::size_t i = 0; i < piece.size(); ++i) path.add(piece[i].x, piece[i].y, i == 0);
  return "<path d=\"" + path.text() + "\" fill=\"none\" " + stroke_of(colour) + " stroke-width=\"" +
         svg_number(series.width) + "\"" +
         (series.look == Look::dashed ? " stroke-dasharray=\"6 4\"" : "") + "/>\n";
}

/// @param phase as above; none if the plot has no other curve
inline std::string draw_curve(const Series& series, const Frame& frame, const SeriesLook& look,
                              std::optional<double> phase) {
  const std::vector<std::vector<Pixel>> curve = pieces(series, frame);
  const bool dots = series.look == Look::dots;
  std::vector<Pixel> marked;
  if (dots || series.x.size() <= most_markers)
    for (const std::vector<Pixel>& piece : curve)
      marked.insert(marked.end(), piece.begin(), piece.end());
  else if (phase)
    marked = places_along(curve, *phase);
  return (dots ? "" : draw_line(curve, series, look.colour)) + draw_markers(marked, look);
}

}  // namespace tumble::support::plot_detail
