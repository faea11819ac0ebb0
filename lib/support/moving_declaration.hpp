#pragma once
/// @file
/// What a page has to know of moving figures, as JSON.

#include <string>

#include "support/moving_figure.hpp"
#include "support/svg.hpp"

namespace tumble::support {

namespace declaration_detail {

/// Names and labels have neither quotes nor control characters: a test looks at all of them.
inline std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

inline std::string of(const Control& control) {
  const auto value = [](std::string_view key, double number) {
    return "," + quoted(key) + ":" + svg_number(number, 6);
  };
  return "{\"name\":" + quoted(control.name) + ",\"label\":" + quoted(control.label) +
         ",\"unit\":" + quoted(control.unit) + ",\"choices\":" + quoted(control.choices) +
         value("least", control.least) + value("most", control.most) + value("step", control.step) +
         value("start", control.start) + "}";
}

}  // namespace declaration_detail

/// A figure: name, plays, pace, drags, topic (what it asks a reader's functions, or ""), and the
/// controls with name, label, unit, choices, least, most, step, start.
inline std::string declaration_of(const MovingFigure& figure) {
  using namespace declaration_detail;
  std::string controls;
  for (const Control& control : figure.controls)
    controls += (controls.empty() ? "" : ",") + of(control);
  return "{\"name\":" + quoted(figure.name) + ",\"plays\":" + std::to_string(figure.plays) +
         ",\"pace\":" + svg_number(figure.pace, 6) +
         ",\"drags\":" + (figure.drag ? "true" : "false") +
         ",\"topic\":" + quoted(figure.reader ? figure.reader->topic : "") + ",\"controls\":[" +
         controls + "]}";
}

}  // namespace tumble::support
