#pragma once
/// @file
/// What an instructor uploads to a platform, or copies into a repository there: ready to run.

#include <optional>
#include <string>

#include "judge/class/settings.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge {

/// Makes the package of a platform in a folder: its README.md says what goes where.
///
/// | platform | in the folder |
/// |---|---|
/// | gradescope | autograder.zip, with the solutions |
/// | prairielearn | image/ (public, without solutions), question/ (with them) |
/// | classroom50 | bundle/ (public, without solutions), assignment.json, template/ |
/// | github-actions | repository/ |
///
/// All hold a course.json with a seed: the one given, or one that is drawn here.
/// @param file  course.json, or nothing for all units
/// @param image of PrairieLearn's grader
/// @param to    does not exist yet, or is empty
/// @throws std::invalid_argument if there is no such platform, or it cannot take these units
void make_package(const Course& course, const std::string& platform,
                  const std::optional<fs::path>& file, const std::string& image,
                  const fs::path& to);

}  // namespace tumble::judge
