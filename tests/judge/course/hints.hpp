#pragma once
/// @file
/// The three hints of a unit: nudge, idea, almost-code.

#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

inline constexpr std::size_t hints_per_unit = 3;

/// The items of the numbered list under the heading "## 4.1 product" of the chapter's hints.md.
/// @throws std::runtime_error naming the file if there are not three
std::vector<std::string> read_hints(const Course& course, const Unit& unit);

}  // namespace tumble::judge
