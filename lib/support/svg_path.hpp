#pragma once
/// @file
/// Lines for SVG, in about half of the bytes that absolute places take once they are packed.

#include <cmath>
#include <string>

#include "support/svg.hpp"

namespace tumble::support {

/// Lines through points, as steps from one point to the next. The points are rounded to a tenth of
/// a pixel first, and a step is the difference of two rounded points: no error adds up on a long
/// line.
class SvgPath {
 public:
  /// Begins a line. [px]
  void move_to(double x, double y) {
    x_ = tenths(x);
    y_ = tenths(y);
    text_ += "M" + svg_number(x_ / 10) + " " + svg_number(y_ / 10);
    command_ = "l";
  }

  /// Goes on to a point; nowhere if it is rounded to the one before. [px]
  void line_to(double x, double y) {
    const double dx = tenths(x) - x_, dy = tenths(y) - y_;
    if (dx == 0 && dy == 0) return;
    text_ += command_ + svg_number(dx / 10) + " " + svg_number(dy / 10);
    x_ += dx;
    y_ += dy;
    command_ = " ";
  }

  /// Begins a line at the first point, and goes on at each other one.
  void add(double x, double y, bool begins) {
    if (begins)
      move_to(x, y);
    else
      line_to(x, y);
  }

  /// A point, as a line of no length: with round ends it is a dot. [px]
  void speck(double x, double y) {
    const double dx = tenths(x) - x_, dy = tenths(y) - y_;
    text_ += (text_.empty() ? "M" : "m") + svg_number(dx / 10) + " " + svg_number(dy / 10) + "h0";
    x_ += dx;
    y_ += dy;
  }

  /// What a path's attribute d has.
  const std::string& text() const { return text_; }

 private:
  static double tenths(double value) { return std::nearbyint(10 * value); }

  double x_ = 0, y_ = 0;  // of the last point [0.1 px]
  std::string text_, command_;
};

}  // namespace tumble::support
