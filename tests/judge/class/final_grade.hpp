#pragma once
/// @file
/// What a student's work is worth in the end: what it has earned, less what it lost for coming
/// late, or what the instructor has given.

#include <string>
#include <vector>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

struct FinalGrade {
  double points = 0;                 ///< in the end
  double earned = 0;                 ///< by the verdicts alone
  std::vector<std::string> because;  ///< why these two differ: "2 days late: −20 %"
  bool by_hand = false;              ///< the instructor has said something about it
};

FinalGrade final_grade(const CourseSettings& settings, const StudentRecord& record);

/// Can the points be given away? Not while something is not judged, or the judge has failed there.
bool is_complete(const CourseSettings& settings, const StudentRecord& record);

/// What a unit's verdict is worth, or what the instructor has given for it.
double unit_points(const CourseSettings& settings, const StudentRecord& record, const Unit& unit);

/// Is a student meant by what course.json or a command line calls them? By the name of the row, the
/// platform's number, the name or the e-mail address.
bool is_called(const StudentRecord& record, const std::string& what);

}  // namespace tumble::judge
