#pragma once
/// @file
/// Grades a class: several submissions at a time, each in a process of its own, so that a grading
/// that is interrupted goes on where it was.

#include <filesystem>
#include <vector>

#include "judge/class/file_names.hpp"
#include "judge/class/grade_student.hpp"
#include "judge/class/interruption.hpp"

namespace tumble::judge {

/// Where a class's results are kept.
struct GradesFolder {
  std::filesystem::path path;

  std::filesystem::path record_of(const std::string& student) const {
    return path / "students" / (file_name_for(student) + ".json");
  }
  /// Where several submissions of a student count, each has a record of its own.
  std::filesystem::path record_of(const Submission& submission) const {
    if (submission.attempt == 0) return record_of(submission.student);
    return attempt(submission.attempt) / (file_name_for(submission.student) + ".json");
  }
  /// Copies of the files that were judged.
  std::filesystem::path sources(std::size_t number = 0) const {
    return (number == 0 ? path : attempt(number)) / "sources";
  }
  std::filesystem::path attempt(std::size_t number) const {
    return path / "attempts" / std::to_string(number);
  }
  std::filesystem::path feedback() const { return path / "feedback"; }
  std::filesystem::path class_list() const { return path / "class.json"; }
  std::filesystem::path lock() const { return path / "lock"; }
  /// The settings that were graded with.
  std::filesystem::path settings() const { return path / "course.json"; }
  std::filesystem::path roster() const { return path / "roster.csv"; }
  /// Where the submissions were.
  std::filesystem::path submissions() const { return path / "submissions.json"; }
  std::filesystem::path csv() const { return path / "grades.csv"; }
  std::filesystem::path junit() const { return path / "junit.xml"; }
  std::filesystem::path seed() const { return path / "seed"; }
  /// What shards of a class say of themselves.
  std::filesystem::path shards() const { return path / "shards"; }
};

/// Makes the folder, where it is not there yet.
/// @throws std::exception naming the folder if it cannot be one
void create(const GradesFolder& folder);

/// Copies the files of these units that were judged; of a unit without one, none is there then.
void copy_sources(const std::filesystem::path& from, const std::filesystem::path& to,
                  const std::vector<Unit>& units);

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
                                       const GradesFolder& folder, std::size_t at_once,
                                       const Interruption& interruption);

/// Puts aside records that cannot be understood, so that they are made anew.
/// @return what to say of them
std::vector<std::string> set_damaged_aside(const GradesFolder& folder,
                                           const std::vector<Submission>& submissions);

/// A record for each student: of several submissions the best one's. Whose record is not there, as
/// grading was interrupted, has one that says so.
std::vector<StudentRecord> records_of(const GradesFolder& folder, const CourseSettings& settings,
                                      const std::vector<Submission>& submissions);

/// The records of a class as it was graded last, and those that could not be read.
struct KeptRecords {
  std::vector<StudentRecord> records;
  std::vector<std::string> unreadable;
};

/// @throws std::invalid_argument if there are none, or only those of shards
KeptRecords read_records(const GradesFolder& folder);

}  // namespace tumble::judge
