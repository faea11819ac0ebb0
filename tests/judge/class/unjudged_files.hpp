#pragma once
/// @file
/// Files that were meant for an exercise, by their names, and are not judged.

#include <string>
#include <vector>

#include "judge/class/submissions.hpp"

namespace tumble::judge {

/// What is said of them: "product.cc is not judged: it has to be called product.cpp". Each unit
/// that has no file counts, and once.
/// @param sources paths of source files that were handed in
/// @param others paths of all other files
std::vector<std::string> notes_on_unjudged(const std::vector<Unit>& without_file,
                                           const std::vector<fs::path>& sources,
                                           const std::vector<std::string>& others);

/// The same of those in folders where nobody looks: ".work/product.cpp is not judged: it lies in
/// .work/, a hidden folder". Where several exercises of the course have a name, the folder of the
/// chapter tells whose it is.
/// @param hidden paths of source files there
std::vector<std::string> notes_on_hidden(const Course& course,
                                         const std::vector<Unit>& without_file,
                                         const std::vector<fs::path>& hidden);

/// The source files in solutions/, beside an exercises/, that are called as a unit's: its student
/// may have written in the wrong one.
std::vector<fs::path> files_in_solutions(const Unit& unit, const std::vector<fs::path>& sources);

/// "solutions/04_quaternions/product.cpp is not judged: …"
std::string note_on_solutions(const fs::path& path);

}  // namespace tumble::judge
