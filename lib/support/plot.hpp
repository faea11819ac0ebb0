#pragma once
/// @file
/// Curves in a frame, as SVG: linear or log axes, names at the curves' ends instead of a legend.

#include <string>
#include <vector>

#include "support/plot_curve.hpp"
#include "support/plot_frame.hpp"
#include "support/plot_layout.hpp"
#include "support/series.hpp"
#include "support/series_looks.hpp"
#include "support/svg.hpp"

namespace tumble::support {

namespace plot_detail {

/// All but the sheet that it is drawn on.
inline std::string drawing(const Plot& plot, const Layout& layout) {
  const Frame& frame = layout.frame;
  const std::vector<SeriesLook> looks = series_looks(plot.series);
  const auto n = static_cast<double>(plot.series.size());
  std::string svg = axes(plot, frame);
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const double phase = (static_cast<double>(s) + 0.5) / n;
    svg += draw_curve(plot.series[s], frame, looks[s], n > 1 ? std::optional(phase) : std::nullopt);
  }
  for (const Label& label : layout.labels)
    svg += draw_label(label, plot.series[label.series].name, looks[label.series].colour);
  return svg;
}

}  // namespace plot_detail

/// The plot as a complete SVG document.
/// @throws std::invalid_argument if a curve has not as many x as y
inline std::string to_svg(const Plot& plot) {
  using namespace plot_detail;
  const Layout placed = layout(plot);
  return svg_open(width, placed.frame.floor() + bottom, plot.title) + drawing(plot, placed) +
         "</svg>\n";
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
    const Layout placed = layout(plot);
    svg +=
        "<g transform=\"translate(0 " + svg_number(y) + ")\">\n" + drawing(plot, placed) + "</g>\n";
    y += placed.frame.floor() + bottom;
  }
  for (const std::string& note : notes) svg += text(margin, y += line_height, note, fill_of("ink"));
  return svg_open(width, y + margin, title) + svg + "</svg>\n";
}

}  // namespace tumble::support
