#pragma once
/// @file
/// The grades as platforms take them back.
///
/// Source: Moodle, mod/assign/feedback/offline/importgradeslib.php; Canvas,
/// lib/gradebook_importer.rb; Gradescope's "Download Grades", whose columns its users' tools read.

#include <string>
#include <vector>

#include "judge/class/roster.hpp"
#include "judge/class/student_record.hpp"

namespace tumble::judge {

/// The table for a platform. If the roster is that platform's own, its columns are kept, and those
/// of the grades are filled in.
/// @param roster or null
/// @return empty for Lms::none
std::string lms_grades(Lms lms, const CourseSettings& settings,
                       const std::vector<StudentRecord>& records, const Roster* roster);

}  // namespace tumble::judge
