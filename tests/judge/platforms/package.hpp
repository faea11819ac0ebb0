#pragma once
/// @file
/// What an instructor uploads to a platform, or copies into a repository there: ready to run.

#include <optional>
#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Which package is to be made.
struct PackageOrder {
  std::string platform;              ///< "gradescope", …
  fs::path to;                       ///< a folder that does not exist yet, or is empty
  std::optional<fs::path> settings;  ///< course.json; without it all units count
  std::string image = "your-account/tumble-judge";  ///< of PrairieLearn's grader
  bool each = false;                                ///< a question of PrairieLearn for each unit
  std::optional<int> limit;  ///< seconds that the platform gives a submission, if not as usual
};

/// Makes the package of a platform in a folder: its README.md says what goes where.
///
/// | platform | in the folder | who can read it |
/// |---|---|---|
/// | gradescope | autograder.zip, with the solutions | instructors |
/// | prairielearn | image/, without solutions; question/ or questions/, with them | everybody;
/// instructors | | classroom50 | bundle/, assignment.json, template/, without solutions | everybody
/// | | github-actions | repository/, without solutions | students |
///
/// All hold a course.json with a seed. What students can read never holds the seed that was given,
/// but one that is drawn here, and never the rules for single students.
/// @return what the instructor should be told
/// @throws std::invalid_argument if there is no such platform, or it cannot take these units, or
///         cannot keep hidden what is to be hidden
std::vector<std::string> make_package(const Course& course, const PackageOrder& order);

}  // namespace tumble::judge
