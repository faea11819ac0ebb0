#pragma once
/// @file
/// Numbers for other programs: as few digits as give the same double back.

#include <array>
#include <charconv>
#include <string>

namespace tumble::detail {

/// "0.075", where 17 digits are "0.074999999999999997". The sign of a zero is left out.
inline std::string shortest(double value) {
  std::array<char, 32> text{};
  const double no_minus_zero = value == 0 ? 0 : value;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), no_minus_zero).ptr};
}

}  // namespace tumble::detail
