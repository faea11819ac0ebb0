#pragma once
/// @file
/// What has to be built before a command can run: ./tumble asks, and builds it.

#include <optional>
#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Names of CMake targets.
using Targets = std::vector<std::string>;

/// The specs of these units: "spec.04_quaternions.product", …
Targets specs_of(const std::vector<Unit>& units);

/// Everything: all specs, and what makes an engine.
Targets all_specs();

/// The specs of the units that count, by the settings or by default, what reads and writes
/// archives, and an engine if its curves go with the grades.
Targets specs_that_count(const Course& course, const std::optional<fs::path>& file);

}  // namespace tumble::judge
