#pragma once
/// @file
/// A repository for students: the chapters that are asked for with their pages, stubs and specs,
/// the library and the judge, and no solutions.

#include <set>
#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// The folders of the chapters that "1-4,6" or "1 – 4, 6" means: "01_particles", …
/// @throws std::invalid_argument if it means none, or there is none of that number
std::set<std::string> chapters_meant(const Course& course, const std::string& text);

/// What is in a tree beside the library and the judge.
struct TreeParts {
  std::set<std::string> chapters;  ///< "01_particles", …
  bool solutions = false;          ///< no hand-out then, but a tree that judges
};

/// Makes a tree of these chapters, its exercises untouched.
/// @param to does not exist yet, or is empty
/// @throws std::invalid_argument if there is something in the folder already, or the course has no
///         solutions and so is a hand-out itself
void make_tree(const Course& course, const TreeParts& parts, const fs::path& to);

}  // namespace tumble::judge
