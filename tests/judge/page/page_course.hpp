#pragma once
/// @file
/// The units whose specs are in this module, under /course in the module's own file system.

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Written by the build, from the contracts' headings.
extern const std::vector<Unit> page_units;

Course page_course();

}  // namespace tumble::judge
