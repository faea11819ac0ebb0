#pragma once
/// @file
/// What is known about one student's work: a JSON file that is complete and valid at any time, and
/// from which everything else is made (grades, reports, what platforms want).

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "judge/class/settings.hpp"
#include "judge/class/submissions.hpp"
#include "judge/verdict/unit_record.hpp"

namespace tumble::judge {

struct StudentRecord {
  std::string student;
  std::uint64_t seed = 1;         ///< of the inputs
  std::uint64_t judge = 0;        ///< fingerprint of the judge: another one may judge otherwise
  std::string refused;            ///< why the submission was not looked at; empty if it was
  std::vector<UnitRecord> units;  ///< those judged so far, in the course's order
  bool out_of_time = false;       ///< the others were not judged: no time was left

  Identity who = {};                    ///< as a platform or a roster says
  std::vector<std::string> notes = {};  ///< which of two files counted, what else was found, …
  std::map<std::string, std::string> files = {};  ///< by unit: the path that was handed in
  std::string handed_in = {};                     ///< when, if somebody says so
  bool marked_late = false;                       ///< by the platform, which says no time
  std::string together = {};                      ///< of a group: the same for all in it
  std::string incomplete = {};  ///< what of it we do not have: so it was not judged
  bool absent = false;          ///< on the roster, and nothing was handed in

  const UnitRecord* find(const Unit& unit) const;
};

/// What is said of a unit that the deadline has come before.
inline constexpr const char* no_time_left = "not judged: no time left";
/// The verdict on a unit of which there is no file.
inline constexpr const char* not_handed_in = "not handed in";

/// How many units the deadline has come before.
std::size_t count_unreached(const CourseSettings& settings, const StudentRecord& record);

/// Of all points.
double earned(const CourseSettings& settings, const StudentRecord& record);

/// Writes {"schema": "tumble/student/1", "student": …, "points": …, "of": …, "units": […]}.
void write_record(const std::filesystem::path& file, const StudentRecord& record,
                  const CourseSettings& settings);

/// Reads what write_record() has written; nothing if there is no file.
/// @throws std::runtime_error naming the file if it cannot be understood
std::optional<StudentRecord> read_record(const std::filesystem::path& file);

}  // namespace tumble::judge
