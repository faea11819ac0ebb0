#pragma once
/// @file
/// The exercises that course.json means by a text.

#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// What Course::select() knows ("4.1", "product", "4", "all"), and from one such to another: "1-4",
/// "4.2-4.5".
/// @throws std::invalid_argument if there are none; the message says what was probably meant
std::vector<Unit> units_meant(const Course& course, const std::string& text);

}  // namespace tumble::judge
