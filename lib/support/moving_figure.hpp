#pragma once
/// @file
/// Figures that a reader moves: a function from settings to SVG, and what may be set. The chapter's
/// program draws the still picture with it, and the page draws every other one.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/core/require.hpp"

namespace tumble::support {

/// A number that a reader sets, or a choice by its number.
struct Control {
  std::string_view name;   ///< in links and on the command line
  std::string_view label;  ///< for the reader
  std::string_view unit;   ///< empty for a plain number
  double least, most, step, start;
  std::string_view choices = {};  ///< the names of 0, 1, 2 …, parted by |
};

/// The values of a figure's controls, in their order.
using Settings = std::span<const double>;

/// A pointer that was pressed on a grip (support::Sketch) and moved [px of the picture].
struct Drag {
  double x, y;    ///< where it is
  double dx, dy;  ///< since it was here last; 0 when it is pressed

  bool begins() const { return dx == 0 && dy == 0; }
};

/// What a figure asks the reader's own functions, in the page, and shows. Which numbers a topic
/// asks and answers says tests/judge/page/student/figure_TOPIC.cpp.
struct ReadersAnswer {
  std::string_view topic;
  std::vector<double> (*question)(Settings);
  /// The answer to the question of these settings, which stay; no numbers: there is none any more.
  void (*take)(Settings, std::span<const double> answer);
};

struct MovingFigure {
  std::string_view name;              ///< the page shows NAME.svg
  std::span<const Control> controls;  ///< what may be set
  std::string (*draw)(Settings);      ///< a complete SVG document
  /// Changes settings as the reader drags; nullptr if nothing can be dragged.
  void (*drag)(std::span<double>, const Drag&) = nullptr;
  int plays = -1;                         ///< the control that goes on by itself; -1 if none does
  const ReadersAnswer* reader = nullptr;  ///< nullptr: it asks nobody
  double pace = 1;                        ///< by how much it goes on per second
};

/// The nearest value that a control can have.
inline double allowed(const Control& control, double value) {
  require(value == value, "the control ", control.name, " was not set to a number");
  const double steps = std::round((value - control.least) / control.step);
  return std::clamp(control.least + steps * control.step, control.least, control.most);
}

/// How a figure looks before a reader changes it.
inline std::vector<double> start_of(const MovingFigure& figure) {
  std::vector<double> settings;
  for (const Control& control : figure.controls) settings.push_back(control.start);
  return settings;
}

/// " re im"
inline std::string names_of_controls(const MovingFigure& figure) {
  std::string names;
  for (const Control& control : figure.controls) names.append(" ").append(control.name);
  return names;
}

/// The same, changed by "name=value" each.
/// @throws std::invalid_argument for a control that there is not, or a value that it can't have
inline std::vector<double> settings_of(const MovingFigure& figure,
                                       const std::vector<std::string>& changes) {
  std::vector<double> settings = start_of(figure);
  for (const std::string& change : changes) {
    const std::size_t sign = std::min(change.find('='), change.size());
    const auto control =
        std::find_if(figure.controls.begin(), figure.controls.end(),
                     [&](const Control& each) { return each.name == change.substr(0, sign); });
    require(control != figure.controls.end(), "the figure '", figure.name, "' has no control '",
            change.substr(0, sign), "'; there are:", names_of_controls(figure));
    char* end = nullptr;
    const double value = std::strtod(change.c_str() + std::min(sign + 1, change.size()), &end);
    require(sign + 1 < change.size() && *end == 0, "'", change, "' is not CONTROL=NUMBER");
    require(value >= control->least && value <= control->most, control->name, " is ", value,
            "; it must be between ", control->least, " and ", control->most);
    settings[static_cast<std::size_t>(control - figure.controls.begin())] =
        allowed(*control, value);
  }
  return settings;
}

}  // namespace tumble::support
