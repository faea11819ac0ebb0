#pragma once
/// @file
/// Verdicts in the words of platforms that courses use.

#include <map>
#include <string>

#include "judge/class/student_record.hpp"

namespace tumble::judge {

/// Gradescope's results.json: one test a unit, hidden ones shown after the due date. Units that are
/// not judged yet are in it with no points, so that it is valid and complete at any time.
/// @param figure an SVG of the student's engine, or empty
/// Source: Gradescope, "Autograder Specifications", "Output format".
std::string gradescope_results(const CourseSettings& settings, const StudentRecord& all,
                               const std::string& figure);

/// PrairieLearn's results.json: points of every test, a score from 0 to 1; a submission that could
/// not be read, or of which a file does not compile, costs no attempt and has no score. Hidden
/// units show their points and nothing else: the platform has no dates for tests.
/// @param figure as above
/// Source: PrairieLearn, "External grading", "Grading results".
std::string prairielearn_results(const CourseSettings& settings, const StudentRecord& all,
                                 const std::string& figure);

/// Classroom 50's result.json, schema classroom50/result/v1: its scores are whole numbers, so
/// everything counts a hundredfold. Hidden units as with PrairieLearn.
/// @param environment what the runner says: CLASSROOM, ASSIGNMENT, SUBMISSION_TAG, …
/// @throws std::invalid_argument naming the variable that is missing
/// Source: Classroom 50, "Advanced Autograding" and result-v1.schema.json.
std::string classroom50_result(const CourseSettings& settings, const StudentRecord& all,
                               const std::map<std::string, std::string>& environment);

/// A table of the verdicts and what is to be read about them, in GitHub's Markdown: a release's
/// body, a job's summary. Hidden units as with PrairieLearn.
std::string markdown_results(const CourseSettings& settings, const StudentRecord& all);

}  // namespace tumble::judge
