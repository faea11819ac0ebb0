#pragma once
/// @file
/// What a student gets back: the points, and for each exercise what was wrong and why.

#include <string>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

/// Plain text.
std::string feedback_text(const CourseSettings& settings, const StudentRecord& record);

/// A page that needs nothing else: no script, no other file, no network.
std::string feedback_html(const CourseSettings& settings, const StudentRecord& record);

/// The points and a line for each exercise, as the comment field of a platform takes them.
std::string feedback_comment(const CourseSettings& settings, const StudentRecord& record);

/// What is to be known of a submission besides its verdicts: why it was not read, what was found in
/// it, why the points are not those that the verdicts earn. "; " between them.
std::string note_on(const CourseSettings& settings, const StudentRecord& record);

/// Points with at most two digits behind the point, and none that is not needed.
std::string points_text(double points);

}  // namespace tumble::judge
