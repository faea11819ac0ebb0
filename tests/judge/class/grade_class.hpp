#pragma once
/// @file
/// Grades a class: several submissions at a time, each in a process of its own, so that a grading
/// that is interrupted goes on where it was.

#include <filesystem>
#include <vector>

#include "judge/class/grade_student.hpp"

namespace tumble::judge {

/// Where a class's results are kept.
struct GradesFolder {
  std::filesystem::path path;

  std::filesystem::path record_of(const std::string& student) const {
    return path / "students" / (student + ".json");
  }
  std::filesystem::path csv() const { return path / "grades.csv"; }
  std::filesystem::path junit() const { return path / "junit.xml"; }
  std::filesystem::path seed() const { return path / "seed"; }
};

/// The seed of a class: as the settings say, else as it was drawn when grading into this folder
/// began.
std::uint64_t class_seed(const CourseSettings& settings, const GradesFolder& folder);

/// A student whose submission the judge could not grade, and why.
struct FailedStudent {
  std::string student, why;
};

/// Grades all submissions; progress goes to stderr.
/// @return those that the judge itself has failed at
std::vector<FailedStudent> grade_class(const Grading& grading,
                                     const std::vector<Submission>& submissions,
                                     const GradesFolder& folder, std::size_t at_once);

/// The records of these students, as far as they are there.
std::vector<StudentRecord> records_of(const GradesFolder& folder,
                                      const std::vector<Submission>& submissions);

/// All records in a folder, by name.
/// @throws std::invalid_argument if there are none
std::vector<StudentRecord> read_records(const GradesFolder& folder);

}  // namespace tumble::judge
