#pragma once
/// @file
/// What a plot shows: curves and their axes.

#include <string>
#include <vector>

#include "support/axis.hpp"

namespace tumble::support {

/// How points are shown: joined by a line, on which few of them are marked; or as dots alone. A
/// dashed line is for what is there to compare with.
enum class Look { line, dots, dashed };

/// One curve. Points that an axis cannot show (not finite; not positive on a log axis)
/// are left out.
struct Series {
  std::string name;
  std::vector<double> x, y;
  Look look = Look::line;
  std::string colour = "";  ///< of the palette; if empty, the name decides
  double width = 1.8;       ///< of the line [px]
};

/// Whether each axis fills its side of the frame, or a unit is as long on both: for paths.
enum class Aspect { fill, equal };

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  Aspect aspect = Aspect::fill;
};

}  // namespace tumble::support
