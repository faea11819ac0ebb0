#pragma once
/// @file
/// What has to be built before a command can run: ./tumble asks, and builds it.

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

}  // namespace tumble::judge
