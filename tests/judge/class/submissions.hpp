#pragma once
/// @file
/// What a class has handed in: one folder or archive a student, and in it the files of the units.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

struct Submission {
  std::string student;  ///< the name of the folder, or of the archive without its ending
  fs::path path;
  bool is_archive = false;
};

/// All submissions in these folders, by name: each folder in them, each archive (.zip, .tar,
/// .tar.gz, .tgz, .tar.xz, .tar.zst), and nothing else; hidden ones are left out.
/// @throws std::invalid_argument if a folder does not exist or holds none, or two have one name
std::vector<Submission> submissions_in(const std::vector<fs::path>& folders);

/// The paths of all regular files below a folder, relative to it. Links are not followed.
std::vector<fs::path> files_below(const fs::path& folder);

/// Which of `paths` is the file of each unit: …/exercises/04_quaternions/product.cpp, else
/// …/04_quaternions/product.cpp, else product.cpp where one unit only has that name; the one least
/// deep. What lies under tests/ or build/ is no student's, and neither is solutions/ beside an
/// exercises/. Units without a file are left out.
/// @param counted the units that are graded: a name alone means one of them first
std::map<std::string, fs::path> files_of_units(const Course& course,
                                               const std::vector<Unit>& counted,
                                               const std::vector<fs::path>& paths);

}  // namespace tumble::judge
