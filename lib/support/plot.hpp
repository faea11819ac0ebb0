#pragma once
/// @file
/// Curves in a frame, as SVG: linear or log axes, names at the curves' ends instead of a legend.

#include <string>
#include <vector>

#include "support/series.hpp"

namespace tumble::support {

/// The plot as a complete SVG document.
/// @throws std::invalid_argument if a curve has not as many x as y
std::string to_svg(const Plot& plot);

/// Several plots below each other in one document, and below them lines of text.
/// @param title for screen readers
std::string to_svg(const std::string& title, const std::vector<Plot>& plots,
                   const std::vector<std::string>& notes);

}  // namespace tumble::support

#ifndef TUMBLE_COMPILED
#include "support/plot.inl"
#endif
