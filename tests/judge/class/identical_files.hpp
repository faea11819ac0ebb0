#pragma once
/// @file
/// Students whose files are the same to the letter.

#include <string>
#include <vector>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

struct IdenticalFiles {
  Unit unit;
  std::vector<std::string> students;
};

/// Of each unit the groups of students with one text: not the untouched stubs, and not those who
/// have handed in together. The records hold fingerprints of the texts.
std::vector<IdenticalFiles> identical_files(const CourseSettings& settings,
                                            const std::vector<StudentRecord>& records);

/// unit,students: a line each.
std::string identical_csv(const std::vector<IdenticalFiles>& groups);

}  // namespace tumble::judge
