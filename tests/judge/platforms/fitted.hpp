#pragma once
/// @file
/// What students read about their work, short enough for every platform: PrairieLearn throws away
/// results of more than 1 MB, GitHub a release's text of more than 125,000 characters.

#include "judge/class/student_record.hpp"

namespace tumble::judge {

/// Bytes that are kept of a line, of what is said about one unit, and of all together.
inline constexpr std::size_t most_of_line = 400, most_of_unit = 8'000, most_in_all = 100'000;

/// The record with its explanations cut, whatever a student's code has printed. What is short
/// leaves its room to the others; where something is left out, it says so.
StudentRecord fitted(StudentRecord record);

/// The record for where everybody reads everything at any time: of hidden units only their points.
StudentRecord without_hidden(const CourseSettings& settings, StudentRecord record);

}  // namespace tumble::judge
