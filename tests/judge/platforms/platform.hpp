#pragma once
/// @file
/// Where a platform puts a submission, where it looks for the results, and what it calls them.

#include <functional>
#include <string>
#include <vector>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

namespace fs = std::filesystem;

/// One submission on one platform.
struct PlatformRun {
  fs::path submission, results;
  /// Another one for each submission: its inputs follow from it.
  std::string identity;
  /// What goes into `results`, with a figure of the student's engine or an empty text.
  std::function<std::string(const StudentRecord&, const std::string& figure)> text;
  fs::path figure = {};  ///< a file for the figure, too; or empty
};

/// A submission as it lies on the platform.
/// @param root of the platform's folders: "/autograder", "/grade", the student's checkout
/// @throws std::invalid_argument if there is no such platform, or what it promises is not there
PlatformRun platform_run(const std::string& platform, const fs::path& root,
                         const CourseSettings& settings);

}  // namespace tumble::judge
