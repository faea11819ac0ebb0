#pragma once
/// @file
/// Grading a class, hand-outs and packages are a module: who checks an exercise does not build
/// them.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "judge/commands/commands.hpp"
#include "judge/commands/needs.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge {

/// What the module offers, under the name tumble_grading_module.
struct GradingModule {
  /// Grades a class, or a shard of it, or makes one class of its shards.
  int (*grade)(const Course& course, const GradeOptions& options);
  /// Writes one page about a class.
  int (*report)(const Course& course, const ReportOptions& options);
  /// Makes a repository for students.
  int (*handout)(const Course& course, const HandoutOptions& options);
  /// Makes what a platform takes.
  int (*export_package)(const Course& course, const PackageOrder& order);
  /// Grades one submission where a platform has put it, and writes the results where it looks for
  /// them.
  int (*platform)(const Course& course, const PlatformOptions& options);
  /// Judges a student's files again as `grade` did, and says the same.
  int (*check_student)(const Course& course, const CheckOptions& options);
  /// What `check --student` judges: the units of a record, or those of them that were asked for.
  std::vector<Unit> (*units_of_student)(const Course& course, const CheckOptions& options);
  /// The units that count, by the settings or by default, and an engine if its curves go with the
  /// grades.
  Targets (*specs_that_count)(const Course& course, const std::optional<fs::path>& settings);
  /// Those by the settings that `grade` takes: the ones that were given, or those of before.
  Targets (*specs_to_grade)(const Course& course, const GradeOptions& options);
  /// The files in a student's archive.
  /// @param called the archive in messages
  /// @throws std::invalid_argument if it cannot be read: why
  std::function<fs::path(const Unit&)> (*unpacked)(const Course& course, const fs::path& archive,
                                                   const std::string& called);
};

/// @throws std::runtime_error if it is not built
const GradingModule& grading_module(const Course& course);

}  // namespace tumble::judge
