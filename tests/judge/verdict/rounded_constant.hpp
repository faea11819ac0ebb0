#pragma once
/// @file
/// Constants that somebody has typed with a few digits: 0.1667 for 1/6, 3.14 for π.

#include <cstddef>
#include <optional>
#include <string>

namespace tumble::judge {

/// Such a number in a file.
struct RoundedConstant {
  std::string digits;   ///< "0.1667"
  std::size_t line;     ///< from 1
  std::string meant;    ///< "1/6", "π"
  std::string instead;  ///< "1.0 / 6", "std::numbers::pi"
  double error;         ///< what is missing, as a fraction
};

/// The first number of the code (see code_of()) that has three digits of a well-known
/// constant or more, and not all that a double holds.
std::optional<RoundedConstant> rounded_constant_in(const std::string& code);

/// The text of a file with the exact constant for each number of this kind.
std::string with_exact_constants(const std::string& source);

/// The name of a wrong answer that comes from one.
inline constexpr const char* rounded_constant_name = "a rounded constant";

}  // namespace tumble::judge
