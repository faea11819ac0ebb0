#pragma once
/// @file
/// Values as a student reads them.

#include <string>

#include "judge/protocol/value.hpp"

namespace tumble::judge {

/// "(0.6, 0, 0.8)" for a vector; a matrix has a row on each line, indented by `indent` from the
/// second on.
std::string text_of(const Value& value, int digits, std::size_t indent = 0);

}  // namespace tumble::judge
