#pragma once
/// @file
/// The end of every grading, on one machine or on several: tables, feedback, and how it went.

#include <chrono>
#include <string>
#include <vector>

#include "judge/class/class_roll.hpp"
#include "judge/class/grade_class.hpp"

namespace tumble::judge {

/// What happened on the way there.
struct GradingRun {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::vector<FailedStudent> failed = {};
  bool interrupted = false;
  std::string again = "the same command";  ///< what goes on where this has ended
};

/// Writes what there is about a class, says what was written, and how it ended.
/// @return the exit status
int finish_class(const ClassRoll& roll, const GradesFolder& folder, const CourseSettings& settings,
                 const GradingRun& run);

/// Says how the grading of these ended.
/// @return the exit status
int say_end(const std::vector<StudentRecord>& records, const GradingRun& run);

}  // namespace tumble::judge
