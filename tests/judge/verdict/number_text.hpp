#pragma once
/// @file
/// Values as a student reads them.

#include <cstddef>
#include <string>

#include "judge/protocol/value.hpp"

namespace tumble::judge {

inline constexpr std::size_t most_numbers_shown = 12;  ///< of a list of numbers that are shown

/// "(0.6, 0, 0.8)" for a vector; a matrix has a row on each line, indented by `indent` from the
/// second on. Whatever a hostile worker sends, the text stays short.
std::string text_of(const Value& value, int digits, std::size_t indent = 0);

/// A text that a terminal shows as it is: control characters, and those that turn the direction of
/// writing, become question marks. Lines and tabs stay.
std::string printable(const std::string& text);

/// The same on one line, cut after `most` bytes.
std::string one_line(const std::string& text, std::size_t most = 500);

}  // namespace tumble::judge
