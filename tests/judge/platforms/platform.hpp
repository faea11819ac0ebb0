#pragma once
/// @file
/// Where a platform puts a submission, where it looks for the results, and what it calls them.

#include <functional>
#include <map>
#include <string>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

namespace fs = std::filesystem;

/// One submission on one platform.
struct PlatformRun {
  fs::path submission;
  /// Another one for each submission: its inputs follow from it.
  std::string identity;
  /// The files that the platform wants, with their texts.
  std::function<std::map<fs::path, std::string>(const StudentRecord&, const std::string& figure)>
      files;
  fs::path solutions = {};    ///< their sources, if the judge was built without; or empty
  bool status_tells = false;  ///< whether the exit status says that all passed, or only that it ran
};

/// The names of the platforms, for messages.
inline constexpr const char* platforms = "gradescope, prairielearn, classroom50, github-actions";

/// @throws std::invalid_argument if there is no such platform: which one was meant, or which there
///         are
void require_platform(const std::string& name);

/// A submission as it lies on the platform. What there is to be kept from students under `root` is
/// closed to other users.
/// @param root of the platform's folders: "/autograder", "/grade", the student's checkout
/// @throws std::invalid_argument if there is no such platform, or what it promises is not there
PlatformRun platform_run(const std::string& platform, const fs::path& root,
                         const CourseSettings& settings);

}  // namespace tumble::judge
