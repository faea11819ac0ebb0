#pragma once
/// @file
/// Grades one submission, unit after unit; after each of them the student's record is on disk.

#include <filesystem>
#include <functional>
#include <set>

#include "judge/build/object_cache.hpp"
#include "judge/class/judge_fingerprint.hpp"
#include "judge/class/student_record.hpp"
#include "judge/class/submissions.hpp"
#include "judge/sandbox/pipe.hpp"

namespace tumble::judge {

/// What grading one submission needs besides it.
struct Grading {
  const Course& course;
  const CourseSettings& settings;
  std::uint64_t seed;              ///< of the course's inputs; each student's follows from it
  const JudgeFingerprint& judge;   ///< what the verdicts depend on besides
  const ObjectCache& compiled;     ///< by all students
  std::size_t builds_at_once = 0;  ///< for one student; 0: as many as there are cores
  /// Sources of the solutions, where the course was built without: functions that a student's file
  /// calls come from there. Empty: they are the student's own.
  std::filesystem::path solutions = {};
  Clock::time_point deadline = Clock::time_point::max();  ///< no exercise is begun later
  std::filesystem::path keep_sources = {};  ///< for a copy of what was judged; empty: nowhere
  std::set<std::string> only = {};  ///< ids of units to judge again; empty: all that are due
};

/// Grades a submission and keeps its record in `file`. What the file holds already, about the same
/// sources, inputs and judge, is not judged again.
/// What is not reached before the deadline is not in the record, which says so.
/// @param done is called for each unit, with what is known then
void grade_student(const Grading& grading, const Submission& submission,
                   const std::filesystem::path& file,
                   const std::function<void(const StudentRecord&)>& done);

}  // namespace tumble::judge
