#pragma once
/// @file
/// What a class can do, and what it gets wrong: counted over its records.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

/// Something and how often, the most frequent first.
using Counts = std::vector<std::pair<std::string, std::size_t>>;

struct UnitStatistics {
  Unit unit;
  std::size_t passed = 0, failed = 0;
  std::size_t not_started = 0;  ///< the untouched stub, or no file at all
  std::size_t unread = 0;       ///< the submission could not be read
  Counts misconceptions;        ///< students whose numbers were those of each
  Counts outcomes;  ///< of those who failed, by the verdict's summary: "does not compile", …
  Counts laws;      ///< laws that did not hold, of those who failed
  double mean_tries = 0;  ///< of those who passed

  std::size_t all() const { return passed + failed + not_started + unread; }
};

/// Was nothing handed in, or the stub as it was handed out?
bool not_started(const UnitRecord& record);

/// Who is absent is not counted.
/// One for each unit that counts, in the course's order.
std::vector<UnitStatistics> statistics_of(const CourseSettings& settings,
                                          const std::vector<StudentRecord>& records);

}  // namespace tumble::judge
