#pragma once

#include "support/plot.hpp"

#include "support/plot_curve.hpp"
#include "support/plot_frame.hpp"
#include "support/plot_layout.hpp"
#include "support/series_looks.hpp"
#include "support/svg.hpp"
#include "tumble/core/compiled.hpp"

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

TUMBLE_BODY std::string to_svg(const Plot& plot) {
  using namespace plot_detail;
  const Layout placed = layout(plot);
  return svg_open(width, placed.frame.floor() + bottom, plot.title) + drawing(plot, placed) +
         "</svg>\n";
}

TUMBLE_BODY std::string to_svg(const std::string& title, const std::vector<Plot>& plots,
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
