#pragma once
/// @file
/// One class of its shards: looks whether they belong together and nothing is missing, and brings
/// their records into one folder.

#include <vector>

#include "judge/class/shard_manifest.hpp"

namespace tumble::judge {

/// Shards of one class, in order: each number once or more, all judged by one judge, about the
/// same course, settings and students.
class ShardedClass {
 public:
  /// Reads what lies in these folders.
  /// @throws std::invalid_argument naming the folders if it is not all of one class, or records are
  /// not what they should be
  ShardedClass(const Course& course, const std::vector<std::filesystem::path>& folders);

  const ClassRoll& roll() const { return first().manifest.roll; }
  const CourseSettings& settings() const { return settings_; }
  /// The text of course.json, if there was one.
  const std::optional<std::string>& settings_text() const { return first().manifest.settings; }
  /// Fingerprints of the judge, by unit.
  const std::map<std::string, std::uint64_t>& judges() const { return first().manifest.judges; }
  std::size_t count() const { return first().manifest.shard.of; }

  /// Copies records, sources and seed into a folder, if they are not there already.
  void bring_to(const GradesFolder& out) const;

 private:
  const FoundShard& first() const { return found_.front(); }
  const GradesFolder& folder_of(const std::string& student) const;
  void require_all_there() const;
  void require_same_class() const;
  void require_this_course(const Course& course) const;
  void require_sound_records() const;
  std::string wrong_with(const Submission& submission) const;
  std::string wrong_with(const StudentRecord& record, const Submission& submission) const;
  std::string another_record(const Submission& submission) const;

  std::vector<FoundShard> found_;
  CourseSettings settings_;
};

}  // namespace tumble::judge
