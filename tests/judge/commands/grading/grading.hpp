#pragma once
/// @file
/// The commands of the module that grades: see judge/commands/grading_module.hpp, which says what
/// each of them does.

#include "judge/commands/commands.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge {

int grade(const Course& course, const GradeOptions& given);
/// Makes the grades of a class whose shards were judged elsewhere.
int merge(const Course& course, const GradeOptions& options);
int report(const Course& course, const ReportOptions& options);
int hand_out(const Course& course, const HandoutOptions& options);
int export_package(const Course& course, const PackageOrder& order);
int grade_on_platform(const Course& course, const PlatformOptions& options);
int check_student(const Course& course, const CheckOptions& options);
std::vector<Unit> units_of_student(const Course& course, const CheckOptions& options);

}  // namespace tumble::judge
