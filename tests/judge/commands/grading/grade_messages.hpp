#pragma once
/// @file
/// What `grade` says of a class when it is done. Names of students are escaped: no terminal obeys
/// them.

#include <string>
#include <vector>

#include "judge/class/collect.hpp"
#include "judge/class/grade_class.hpp"

namespace tumble::judge {

/// One line a student on stdout, and what there is to know besides the points.
void print_grades(const CourseSettings& settings, const std::vector<StudentRecord>& records);

/// A list on stderr, cut where nobody reads on; nothing if it is empty.
void say_list(const std::string& head, const std::vector<std::string>& lines);

/// What to know of the class before the grades are given away: every entry that has no row, who is
/// not on the roster, names that nobody has, identical files, work without a time.
void say_about(const std::vector<LeftOut>& left_out, const std::vector<std::string>& strangers,
               const CourseSettings& settings, const std::vector<StudentRecord>& records);

/// Says which verdicts on the same files have changed, since the judge, its specs or the seed did.
void say_changes(const std::vector<StudentRecord>& before, const std::vector<StudentRecord>& after);

/// Says what the judge has failed at.
/// @param again what judges what is missing: "the same command"
/// @return whether there was anything
bool say_failures(const std::vector<FailedStudent>& failed,
                  const std::vector<StudentRecord>& records, const std::string& again);

}  // namespace tumble::judge
