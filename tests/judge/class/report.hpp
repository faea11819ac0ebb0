#pragma once
/// @file
/// One page about a class: what it can do, what it gets wrong, and what to explain again.

#include <string>
#include <vector>

#include "judge/class/statistics.hpp"

namespace tumble::judge {

/// Whose names are on the page.
enum class Names { hidden, shown };

/// A page of HTML that needs nothing else: no script, no other file, no network.
std::string report_html(const CourseSettings& settings, const std::vector<StudentRecord>& records,
                        Names names);

}  // namespace tumble::judge
