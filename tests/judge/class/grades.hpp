#pragma once
/// @file
/// The grades of a class as other programs read them: a table for spreadsheets, JUnit for
/// everything that shows tests.

#include <string>
#include <vector>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

/// student,points,of,percent,passed,note,1.1 flatten,1.2 dydt,… : one line a student, points in the
/// columns of the units (empty: not judged). Where a platform or a roster says who the students
/// are, three columns more: name,id,email. Quoted where needed (RFC 4180); a text that a
/// spreadsheet would take for a formula begins with an apostrophe.
std::string grades_csv(const CourseSettings& settings, const std::vector<StudentRecord>& records);

/// One test suite a student, one test case a unit.
std::string grades_junit(const CourseSettings& settings, const std::vector<StudentRecord>& records);

}  // namespace tumble::judge
