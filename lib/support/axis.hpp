#pragma once
/// @file
/// One axis of a plot: which values it covers, where its ticks are, what they are called.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/svg.hpp"

namespace tumble::support {

enum class Scale { linear, log };

struct Axis {
  std::string label;  ///< the quantity and its unit
  Scale scale = Scale::linear;
};

struct Tick {
  double value;
  std::string label;
};

/// The exponent n as 10ⁿ in superscript digits.
inline std::string power_of_ten(int exponent) {
  static const std::vector<std::string> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent)))
    text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

/// An axis fitted to data: maps a value to [0, 1].
class FittedAxis {
 public:
  explicit FittedAxis(const Axis& axis) : axis_(axis) {}

  /// Whether the value can be shown: finite, and positive on a log axis.
  bool shows(double value) const {
    return std::isfinite(value) && (axis_.scale == Scale::linear || value > 0);
  }

  /// Widens the range so that it holds the value.
  void include(double value) {
    if (!shows(value)) return;
    low_ = std::min(low_, warp(value));
    high_ = std::max(high_, warp(value));
  }

  /// Rounds the range outwards; call once when all data is in.
  void finish() {
    if (low_ > high_) {
      low_ = 0;
      high_ = 1;
    }
    if (axis_.scale == Scale::log) {
      low_ = std::floor(low_ + 1e-9);
      high_ = std::max(std::ceil(high_ - 1e-9), low_ + 1);
      return;
    }
    if (high_ - low_ < 1e-300) {
      low_ -= 0.5;
      high_ += 0.5;
    }
    const double step = linear_step();
    low_ = std::floor(low_ / step + 1e-9) * step;
    high_ = std::ceil(high_ / step - 1e-9) * step;
  }

  double position(double value) const { return (warp(value) - low_) / (high_ - low_); }

  /// How many units (on a log axis: powers of ten) there are from end to end.
  double span() const { return high_ - low_; }

  std::vector<Tick> ticks() const {
    std::vector<Tick> list;
    if (axis_.scale == Scale::log) {
      const int every = static_cast<int>(std::ceil((high_ - low_) / 8));
      for (int e = static_cast<int>(low_); e <= static_cast<int>(high_); e += every)
        list.push_back({std::pow(10.0, e), power_of_ten(e)});
      return list;
    }
    const double step = linear_step();
    const int count = static_cast<int>(std::lround((high_ - low_) / step));
    for (int i = 0; i <= count; ++i) {
      const double value = low_ + i * step;
      list.push_back({value, tick_number(value, step)});
    }
    return list;
  }

 private:
  /// As many digits as tell the ticks apart. Where they would be more than can be written, the
  /// largest power of ten stands behind them.
  std::string tick_number(double value, double step) const {
    constexpr int most_digits = 15, most_of_mantissa = 9;
    const auto digits_to = [&](double unit) {
      return std::max(0, static_cast<int>(std::ceil(std::log10(unit / step) - 1e-9)));
    };
    const double largest = std::max(std::abs(low_), std::abs(high_));
    const int digits = digits_to(1);
    if (digits <= most_digits && largest * std::pow(10.0, digits) < 0x1p51)
      return svg_number(value, digits);
    const int exponent = static_cast<int>(std::floor(std::log10(largest)));
    const double unit = std::pow(10.0, exponent);
    const std::string mantissa =
        svg_number(value / unit, std::min(most_of_mantissa, digits_to(unit)));
    return mantissa == "0" ? mantissa : mantissa + " · " + power_of_ten(exponent);
  }

  double warp(double value) const { return axis_.scale == Scale::log ? std::log10(value) : value; }

  /// 1, 2 or 5 times a power of ten, so that there are about five steps.
  double linear_step() const {
    const double rough = (high_ - low_) / 5;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
      if (rough <= factor * power * 1.0001) return factor * power;
    return 10 * power;
  }

  Axis axis_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace tumble::support
