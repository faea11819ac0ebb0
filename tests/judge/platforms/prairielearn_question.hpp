#pragma once
/// @file
/// What a question on PrairieLearn says about itself and about its exercises.

#include <map>
#include <optional>
#include <string>

#include "judge/class/settings.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge {

/// What stands for @NAME@ in the files of a package, by NAME.
using Words = std::map<std::string, std::string>;

/// What grades a question.
struct Grader {
  std::string image;
  std::optional<int> limit;  ///< seconds that it has, if not as many as its exercises may need
};

/// Writes info.json and, for students to download, the stubs and contracts.
/// @param question its folder
/// @return UNITS and FILES of question.html
/// @throws std::invalid_argument if two units have one name: PrairieLearn has no folders
/// Source: PrairieLearn, infoQuestion.json and "External grading".
Words write_question(const Course& course, const CourseSettings& settings, const Grader& grader,
                     const fs::path& question);

}  // namespace tumble::judge
