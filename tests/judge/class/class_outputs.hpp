#pragma once
/// @file
/// All files that a grading leaves besides the records: tables, JUnit, feedback, and what a report
/// needs to know of the class.

#include <vector>

#include "judge/class/grade_class.hpp"
#include "judge/class/lms.hpp"
#include "judge/class/roster.hpp"

namespace tumble::judge {

/// A graded class.
struct GradedClass {
  const CourseSettings& settings;
  const std::vector<StudentRecord>& records;  ///< a row each
  const std::vector<Submission>& submissions;
  Lms lms = Lms::none;
  const Roster* roster = nullptr;
};

/// Writes them.
/// @return those that an instructor looks for, by path
std::vector<std::filesystem::path> write_outputs(const GradesFolder& folder,
                                                 const GradedClass& graded);

}  // namespace tumble::judge
