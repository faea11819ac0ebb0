#pragma once
/// @file
/// The frame of a plot: where a point of the curves is drawn, the axes and their ticks.

#include <algorithm>
#include <string>

#include "support/axis.hpp"
#include "support/series.hpp"
#include "support/svg.hpp"
#include "tumble/core/require.hpp"

namespace tumble::support::plot_detail {

constexpr double width = 760, left = 74, right = 178, top = 44, bottom = 56;
constexpr double narrow_right = 24;                          // where no name is beside the frame
constexpr double across = width - left - right, down = 340;  // what the axes enclose
constexpr double most_down = 480;                            // of a frame with equal scales

struct Frame {
  FittedAxis x, y;
  double across = plot_detail::across, down = plot_detail::down;

  double right_end() const { return left + across; }
  double floor() const { return top + down; }
  double px(double value) const { return left + x.position(value) * across; }
  double py(double value) const { return floor() - y.position(value) * down; }
  bool shows(double a, double b) const { return x.shows(a) && y.shows(b); }
};

/// @param room from end to end of the horizontal axis
inline Frame fitted_frame(const Plot& plot, double room = across) {
  Frame frame{FittedAxis(plot.x), FittedAxis(plot.y), room};
  for (const Series& series : plot.series) {
    require(series.x.size() == series.y.size(), "plot '", plot.title, "': curve '", series.name,
            "' has ", series.x.size(), " x but ", series.y.size(), " y");
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!frame.shows(series.x[i], series.y[i])) continue;
      frame.x.include(series.x[i]);
      frame.y.include(series.y[i]);
    }
  }
  frame.x.finish();
  frame.y.finish();
  if (plot.aspect == Aspect::equal) {
    const double unit = std::min(room / frame.x.span(), most_down / frame.y.span());
    frame.across = unit * frame.x.span();
    frame.down = unit * frame.y.span();
  }
  return frame;
}

inline std::string line(double x1, double y1, double x2, double y2, const std::string& look) {
  return "<line x1=\"" + svg_number(x1) + "\" y1=\"" + svg_number(y1) + "\" x2=\"" +
         svg_number(x2) + "\" y2=\"" + svg_number(y2) + "\" " + look + "/>\n";
}

inline std::string text(double x, double y, const std::string& words,
                        const std::string& attributes) {
  return "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" " + attributes + ">" +
         svg_words(words) + "</text>\n";
}

inline std::string axes(const Plot& plot, const Frame& frame) {
  const std::string ink = fill_of("ink"), grid = stroke_of("grid"), faint = stroke_of("faint");
  const std::string middle = ink + " text-anchor=\"middle\"", end = ink + " text-anchor=\"end\"";
  std::string svg;
  for (const Tick& tick : frame.x.ticks()) {
    const double x = frame.px(tick.value);
    svg += line(x, top, x, frame.floor(), grid);
    svg += text(x, frame.floor() + 18, tick.label, middle);
  }
  for (const Tick& tick : frame.y.ticks()) {
    const double y = frame.py(tick.value);
    svg += line(left, y, frame.right_end(), y, grid);
    svg += text(left - 8, y + 4, tick.label, end);
  }
  svg += line(left, frame.floor(), frame.right_end(), frame.floor(), faint);
  svg += line(left, top, left, frame.floor(), faint);
  svg += text(left + frame.across / 2, frame.floor() + bottom - 14, plot.x.label, middle);
  svg += text(left - 62, top - 12, plot.y.label, ink);
  svg += text(width - 12, top - 12, plot.title, end + " font-weight=\"600\"");
  return svg;
}

}  // namespace tumble::support::plot_detail
