#pragma once
/// @file
/// The exercises that course.json, or --only, means by a text.

#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// What Course::select() knows ("4.1", "product", "4", "all"), and from one such to another: "1-4",
/// "4.2-4.5", " 1 – 4 " with the dash that an editor makes of a hyphen.
/// @throws std::invalid_argument if there are none; the message says what was probably meant
std::vector<Unit> units_meant(const Course& course, const std::string& text);

/// Those of them that count.
/// @throws std::invalid_argument if there are none
std::vector<Unit> counted_units(const Course& course, const std::vector<Unit>& counted,
                                const std::string& text);

}  // namespace tumble::judge
