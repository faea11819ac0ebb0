#pragma once
/// @file
/// Whom course.json and a command line mean by a name.

#include <string>
#include <vector>

#include "judge/class/class_roll.hpp"
#include "judge/class/rules.hpp"
#include "judge/class/student_record.hpp"

namespace tumble::judge {

/// Everybody who has a row: their names alone.
std::vector<StudentRecord> everybody(const ClassRoll& roll);

/// The rows that are meant. A row's name is meant whatever its case, unless another row has it as
/// it is written.
std::vector<std::string> rows_called(const std::vector<StudentRecord>& all,
                                     const std::string& name);

/// The rules, with a row's name written as the row has it.
/// An extension, and points by hand, are one student's. Who is unknown stays as written.
/// @throws std::invalid_argument if course.json calls a student by what several are called, or one
///         student twice
ClassRules with_names_of_rows(ClassRules rules, const std::vector<StudentRecord>& all);

}  // namespace tumble::judge
