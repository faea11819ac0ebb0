#pragma once
/// @file
/// A curve of very many points, as a plot can show it.
///
/// Source: Jugel, Jerzak, Hackenbroich and Markl, "M4: A Visualization-Oriented Time Series Data
/// Aggregation" (2014).

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "support/series.hpp"

namespace tumble::support {

/// Takes the points of a curve one after the other. Few points stay as they are. Of many, each of
/// the columns that the frame has keeps the first, the lowest, the highest and the last one: the
/// line through these covers the same pixels.
class Envelope {
 public:
  /// @param points how many will come, x rising evenly
  explicit Envelope(std::size_t points) : points_(points) {}

  void add(double x, double y) {
    const Point point{x, y};
    const std::size_t column = points_ <= 4 * columns ? taken_ : taken_ * columns / points_;
    if (taken_ == 0 || column != column_) {
      finish_column();
      low_ = high_ = first_ = point;
    }
    if (point.second < low_.second) low_ = point;
    if (point.second > high_.second) high_ = point;
    last_ = point;
    column_ = column;
    ++taken_;
  }

  /// The curve, once all points were added.
  void write_to(Series& series) {
    finish_column();
    series.x = std::move(x_);
    series.y = std::move(y_);
  }

 private:
  using Point = std::pair<double, double>;

  static constexpr std::size_t columns = 600;  // one per pixel, or so

  void finish_column() {
    if (taken_ == 0) return;
    for (const Point& point : {first_, std::min(low_, high_), std::max(low_, high_), last_}) {
      if (!x_.empty() && x_.back() == point.first) continue;
      x_.push_back(point.first);
      y_.push_back(point.second);
    }
  }

  std::size_t points_, taken_ = 0, column_ = 0;
  Point first_, low_, high_, last_;  ///< of the column
  std::vector<double> x_, y_;
};

}  // namespace tumble::support
