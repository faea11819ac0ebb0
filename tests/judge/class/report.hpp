#pragma once
/// @file
/// One page about a class: what it can do, what it gets wrong, and what to explain again.

#include <string>
#include <vector>

#include "judge/class/identical_files.hpp"
#include "judge/class/statistics.hpp"

namespace tumble::judge {

/// Whose names are on the page.
enum class Names { hidden, shown };

/// What was found besides the verdicts.
struct ReportNotes {
  std::vector<std::string> unreadable;    ///< records that are left out, and why
  std::vector<IdenticalFiles> identical;  ///< files that are the same to the letter
};

/// A page of HTML that needs nothing else: no script, no other file, no network.
std::string report_html(const CourseSettings& settings, const std::vector<StudentRecord>& records,
                        Names names, const ReportNotes& notes = {});

}  // namespace tumble::judge
