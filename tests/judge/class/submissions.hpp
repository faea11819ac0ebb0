#pragma once
/// @file
/// What a student has handed in, and in it the files of the units.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Who a student is, as far as a platform or a roster says.
struct Identity {
  std::string name;   ///< for people
  std::string id;     ///< the platform's number
  std::string email;  ///< or empty
};

/// A folder, an archive or a single file that was handed in.
struct Part {
  std::string name;  ///< what its paths begin with; a single file's name. Empty: nothing
  fs::path path;
};

struct Submission {
  std::string student;  ///< names the row and the record, and the inputs follow from it
  fs::path path;        ///< the folder or the archive; of many parts, the folder that they lie in
  bool is_archive = false;
  std::vector<Part> parts = {};  ///< if it is more than that
  Identity who = {};
  std::string refused = {};     ///< why it is not looked at; empty if it is
  std::string incomplete = {};  ///< what of it we do not have, which is not the student's doing
  std::vector<std::string> notes = {};  ///< what one should know about it
  std::string handed_in = {};           ///< when, if somebody says so: ISO 8601 with a time zone
  bool marked_late = false;             ///< the platform says so, and not by how much
  std::string answer_under = {};        ///< the path that a platform gives feedback back by
  std::string together = {};            ///< a name for the group that has handed it in together
  std::size_t attempt = 0;              ///< 1, 2, … where several of one student count
};

/// All its parts: itself, if it has no others.
std::vector<Part> parts_of(const Submission& submission);

/// The paths of all regular files below a folder, relative to it and in natural order. Links are
/// not followed.
std::vector<fs::path> files_below(const fs::path& folder);

/// The source files in hidden folders below a folder, relative to it, as far as they are seen in
/// passing: what cannot be read is passed over, .git is never looked into, and after 20,000 entries
/// nothing is.
std::vector<fs::path> hidden_sources_below(const fs::path& folder);

/// The file that counts for a unit, and the others that could have been meant.
struct ChosenFile {
  fs::path path;
  std::vector<fs::path> others;
};

/// Which of `paths` is the file of each unit: …/exercises/04_quaternions/product.cpp, else
/// …/04_quaternions/product.cpp, else product.cpp where one unit only has that name; of several the
/// one least deep, and of those the last in natural order. What lies under tests/ or build/
/// is no student's, and neither is solutions/ beside an exercises/. Units without a file are left
/// out.
/// @param counted the units that are graded: a name alone means one of them first
std::map<std::string, ChosenFile> choose_files(const Course& course,
                                               const std::vector<Unit>& counted,
                                               const std::vector<fs::path>& paths);

/// The source files among `paths` that are no exercise's by their names, and by their places could
/// be: not in the folders of the course itself (tests/, lib/, …), and none of `chosen`.
std::vector<fs::path> not_exercises(const std::map<std::string, ChosenFile>& chosen,
                                    const std::vector<fs::path>& paths);

/// The folder of the course, not of the student's, that a source file lies in: "build". Empty if it
/// lies in none, or if all of the course is there: its own files are not the student's.
std::string folder_of_the_course(const fs::path& path, const std::vector<fs::path>& paths);

/// The same without the others.
std::map<std::string, fs::path> files_of_units(const Course& course,
                                               const std::vector<Unit>& counted,
                                               const std::vector<fs::path>& paths);

}  // namespace tumble::judge
