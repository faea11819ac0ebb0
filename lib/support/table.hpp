#pragma once
/// @file
/// A table of text for the terminal and the page, and the same rows as CSV.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "support/csv.hpp"
#include "support/printable.hpp"
#include "support/wrapped.hpp"
#include "tumble/core/require.hpp"

namespace tumble::support {

/// A number with `digits` significant digits, in scientific notation where that is shorter. A zero
/// has no sign.
inline std::string number(double value, int digits = 3) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value + 0.0);
  return text.data();
}

/// An error, to one digit more than one can trust: 1.3e-15.
inline std::string error_number(double value) {
  if (value == 0) return "0";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1e", value);
  return text.data();
}

/// The same, or that it is not worth telling from rounding: what decides such digits is chance.
inline std::string error_or_rounding(double value) {
  if (std::isnan(value)) return "not a number";
  return std::abs(value) < 1e-14 ? "< 1e-14" : error_number(value);
}

/// The order that two errors show, the second with half the step.
inline std::string order_text(double coarse, double fine) {
  return number(std::log2(coarse / fine), 2);
}

/// An angle [rad] in degrees: 51.4°.
inline std::string degrees(double angle, int digits = 4) {
  return number(angle * 180 / std::numbers::pi, digits) + "°";
}

/// A time [s] in the unit that fits: ns, µs, ms or s.
inline std::string duration(double seconds) {
  if (seconds < 1e-6) return number(seconds * 1e9) + " ns";
  if (seconds < 1e-3) return number(seconds * 1e6) + " µs";
  if (seconds < 1) return number(seconds * 1e3) + " ms";
  return number(seconds) + " s";
}

/// How many times as large: 0.43 ×, 9.1 ×, and from 100 on whole: 225 ×.
inline std::string times(double ratio) {
  const int digits = ratio < 100 ? 2 : static_cast<int>(std::log10(ratio)) + 1;
  return number(ratio, digits) + " ×";
}

/// Columns with a heading each; the first is flush left, the others flush right.
class Table {
 public:
  explicit Table(std::vector<std::string> headings) : rows_{std::move(headings)} {}

  /// @throws std::invalid_argument if the row has not as many cells as there are headings
  void add(std::vector<std::string> cells) {
    require(cells.size() == rows_[0].size(), "a row of ", cells.size(), " cells in a table of ",
            rows_[0].size(), " columns");
    rows_.push_back(std::move(cells));
  }

  std::string text() const {
    std::string out;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t c = 0; c < rows_[r].size(); ++c) {
        const std::string gap(column_width(c) - characters(cell(r, c)), ' ');
        out += c == 0 ? "  " + cell(r, c) + gap : "   " + gap + cell(r, c);
      }
      out.erase(out.find_last_not_of(' ') + 1);
      out += '\n';
      if (r == 0) out += rule();
    }
    return out;
  }

  /// The same if no line is longer than `width` characters. Or else each row becomes a few lines
  /// that break between words: its first cell, and below it the others, each with its heading.
  std::string text_within(std::size_t width) const {
    std::size_t line = 2;
    for (std::size_t c = 0; c < rows_[0].size(); ++c) line += column_width(c) + (c == 0 ? 0 : 3);
    if (line <= width) return text();
    std::string out = wrapped(cell(0, 0), width, 2) + '\n';
    for (std::size_t r = 1; r < rows_.size(); ++r) {
      out += "  " + wrapped(cell(r, 0), width - 2, 4) + '\n';
      for (std::size_t c = 1; c < rows_[r].size(); ++c)
        if (!rows_[r][c].empty())
          out += "    " + wrapped(cell(0, c) + ": " + cell(r, c), width - 4, 6) + '\n';
    }
    return out;
  }

  /// The rows as comma-separated values, quoted where a cell has a comma or a quote.
  std::string csv() const {
    std::string out;
    for (const std::vector<std::string>& row : rows_) {
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (c > 0) out += ',';
        out += csv_field(row[c]);
      }
      out += '\n';
    }
    return out;
  }

 private:
  /// As it is shown: names come from files of others.
  std::string cell(std::size_t r, std::size_t c) const { return escaped(rows_[r][c]); }

  std::size_t column_width(std::size_t c) const {
    std::size_t width = 0;
    for (std::size_t r = 0; r < rows_.size(); ++r) width = std::max(width, characters(cell(r, c)));
    return width;
  }

  std::string rule() const {
    std::string out;
    for (std::size_t c = 0; c < rows_[0].size(); ++c) {
      out += c == 0 ? "  " : "   ";
      for (std::size_t i = 0; i < column_width(c); ++i) out += "─";
    }
    return out + '\n';
  }

  std::vector<std::vector<std::string>> rows_;
};

}  // namespace tumble::support
