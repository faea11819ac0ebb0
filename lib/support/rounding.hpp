#pragma once
/// @file
/// How an error is written of which only rounding is left.

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble::support {

/// A power of ten, three times of which an error of rounding is below: its digits are chance.
/// @param least an error that is not told from 0
inline std::string rounding_number(double error, double least = 1e-15) {
  const double power = std::ceil(std::log10(std::max(3 * std::abs(error), least)));
  return "< 1e" + std::to_string(static_cast<int>(power));
}

}  // namespace tumble::support
