#pragma once
/// @file
/// Has anybody written in a student's file?

#include <filesystem>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Is a file the exercise as it was handed out? Of what cannot be read it is not said.
bool is_untouched(const Course& course, const Unit& unit, const std::filesystem::path& file);

}  // namespace tumble::judge
