#pragma once
/// @file
/// Where a unit crashes: the same case again, with sanitizers.

#include <filesystem>
#include <string>

#include "judge/course/course.hpp"
#include "judge/spec/run.hpp"

namespace tumble::judge {

/// "product.cpp:12: heap-buffer-overflow", or empty if the sanitizers do not see it.
std::string crash_place(const Course& course, const SpecRun& run, const Unit& unit,
                        const std::filesystem::path& source, const std::filesystem::path& folder);

}  // namespace tumble::judge
