#pragma once
/// @file
/// Curves in a frame, as SVG: linear or log axes, names at the curves' ends instead of a legend.

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "support/axis.hpp"
#include "support/series.hpp"
#include "support/svg.hpp"
#include "tumble/core/require.hpp"

namespace tumble::support {

namespace plot_detail {

constexpr double width = 760, left = 74, right = 178, top = 44, bottom = 56;
constexpr double across = width - left - right, down = 340;  // what the axes enclose
constexpr double most_down = 480;                            // of a frame with equal scales
constexpr double text_height = 15;
constexpr std::size_t colours = 10;       // --c0 … --c9 of the style
constexpr std::size_t most_markers = 40;  // a curve with more points is a line

struct Frame {
  FittedAxis x, y;
  double across = plot_detail::across, down = plot_detail::down;

  double right_end() const { return left + across; }
  double floor() const { return top + down; }
  double px(double value) const { return left + x.position(value) * across; }
  double py(double value) const { return floor() - y.position(value) * down; }
};

inline std::string line(double x1, double y1, double x2, double y2, const char* colour) {
  return "<line x1=\"" + svg_number(x1) + "\" y1=\"" + svg_number(y1) + "\" x2=\"" +
         svg_number(x2) + "\" y2=\"" + svg_number(y2) + "\" stroke=\"var(--" + colour + ")\"/>\n";
}

inline std::string text(double x, double y, const std::string& words,
                        const std::string& attributes) {
  return "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" " + attributes + ">" +
         svg_text(words) + "</text>\n";
}

inline std::string axes(const Plot& plot, const Frame& frame) {
  std::string svg;
  for (const Tick& tick : frame.x.ticks()) {
    const double x = frame.px(tick.value);
    svg += line(x, top, x, frame.floor(), "grid");
    svg += text(x, frame.floor() + 18, tick.label, "fill=\"var(--ink)\" text-anchor=\"middle\"");
  }
  for (const Tick& tick : frame.y.ticks()) {
    const double y = frame.py(tick.value);
    svg += line(left, y, frame.right_end(), y, "grid");
    svg += text(left - 8, y + 4, tick.label, "fill=\"var(--ink)\" text-anchor=\"end\"");
  }
  svg += line(left, frame.floor(), frame.right_end(), frame.floor(), "faint");
  svg += line(left, top, left, frame.floor(), "faint");
  svg += text(left + frame.across / 2, frame.floor() + bottom - 14, plot.x.label,
              "fill=\"var(--ink)\" text-anchor=\"middle\"");
  svg += text(left - 62, top - 12, plot.y.label, "fill=\"var(--ink)\"");
  svg += text(width - 12, top - 12, plot.title,
              "fill=\"var(--ink)\" text-anchor=\"end\" font-weight=\"600\"");
  return svg;
}

inline std::string colour_of(std::size_t index) {
  return "var(--c" + std::to_string(index % colours) + ")";
}

inline std::string curve(const Series& series, const Frame& frame, const std::string& colour) {
  std::string path, markers;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!frame.x.shows(series.x[i]) || !frame.y.shows(series.y[i])) {
      pen_down = false;
      continue;
    }
    const std::string x = svg_number(frame.px(series.x[i])), y = svg_number(frame.py(series.y[i]));
    path += (pen_down ? "L" : "M") + x + " " + y;
    pen_down = true;
    if (series.look == Look::dots || series.x.size() <= most_markers)
      markers += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"3\" fill=\"" + colour + "\"/>\n";
  }
  if (series.look == Look::dots) return markers;
  const std::string dashes = series.look == Look::dashed ? " stroke-dasharray=\"6 4\"" : "";
  return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.8\"" +
         dashes + "/>\n" + markers;
}

struct EndLabel {
  std::size_t series;
  double y;
};

/// Where each curve's name stands: at the height of its last point, pushed apart where
/// they would overlap.
inline std::vector<EndLabel> end_labels(const Plot& plot, const Frame& frame) {
  std::vector<EndLabel> labels;
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const Series& series = plot.series[s];
    for (std::size_t i = series.x.size(); i-- > 0;) {
      if (!frame.x.shows(series.x[i]) || !frame.y.shows(series.y[i])) continue;
      labels.push_back({s, frame.py(series.y[i])});
      break;
    }
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const EndLabel& a, const EndLabel& b) { return a.y < b.y; });
  for (std::size_t i = 1; i < labels.size(); ++i)
    labels[i].y = std::max(labels[i].y, labels[i - 1].y + text_height);
  // What was pushed out below comes back up, and pushes its neighbours in turn.
  double limit = frame.floor() - 2;
  for (std::size_t i = labels.size(); i-- > 0; limit = labels[i].y - text_height)
    labels[i].y = std::min(labels[i].y, limit);
  return labels;
}

inline Frame fitted_frame(const Plot& plot) {
  Frame frame{FittedAxis(plot.x), FittedAxis(plot.y)};
  for (const Series& series : plot.series) {
    require(series.x.size() == series.y.size(), "plot '", plot.title, "': curve '", series.name,
            "' has ", series.x.size(), " x but ", series.y.size(), " y");
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!frame.x.shows(series.x[i]) || !frame.y.shows(series.y[i])) continue;
      frame.x.include(series.x[i]);
      frame.y.include(series.y[i]);
    }
  }
  frame.x.finish();
  frame.y.finish();
  if (plot.aspect == Aspect::equal) {
    const double unit = std::min(across / frame.x.span(), most_down / frame.y.span());
    frame.across = unit * frame.x.span();
    frame.down = unit * frame.y.span();
  }
  return frame;
}

/// All but the sheet that it is drawn on.
inline std::string drawing(const Plot& plot, const Frame& frame) {
  std::string svg = axes(plot, frame);
  for (std::size_t s = 0; s < plot.series.size(); ++s)
    svg += curve(plot.series[s], frame, colour_of(s));
  for (const EndLabel& label : end_labels(plot, frame))
    svg += text(frame.right_end() + 10, label.y + 4, plot.series[label.series].name,
                "fill=\"" + colour_of(label.series) + "\"");
  return svg;
}

}  // namespace plot_detail

/// The plot as a complete SVG document.
/// @throws std::invalid_argument if a curve has not as many x as y
inline std::string to_svg(const Plot& plot) {
  using namespace plot_detail;
  const Frame frame = fitted_frame(plot);
  return svg_open(width, frame.floor() + bottom, plot.title) + drawing(plot, frame) + "</svg>\n";
}

/// Several plots below each other in one document, and below them lines of text.
/// @param title for screen readers
inline std::string to_svg(const std::string& title, const std::vector<Plot>& plots,
                          const std::vector<std::string>& notes) {
  using namespace plot_detail;
  constexpr double line_height = 19, margin = 12;
  std::string svg;
  double y = 0;
  for (const Plot& plot : plots) {
    const Frame frame = fitted_frame(plot);
    svg +=
        "<g transform=\"translate(0 " + svg_number(y) + ")\">\n" + drawing(plot, frame) + "</g>\n";
    y += frame.floor() + bottom;
  }
  for (const std::string& note : notes)
    svg += text(margin, y += line_height, note, "fill=\"var(--ink)\"");
  return svg_open(width, y + margin, title) + svg + "</svg>\n";
}

}  // namespace tumble::support
