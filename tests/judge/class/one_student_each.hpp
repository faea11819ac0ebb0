#pragma once
/// @file
/// Whom course.json means by a name.

#include "judge/class/class_roll.hpp"
#include "judge/class/rules.hpp"

namespace tumble::judge {

/// An extension, and points by hand, are one student's.
/// @throws std::invalid_argument if course.json calls a student by what several are called
void require_one_student_each(const ClassRules& rules, const ClassRoll& roll);

}  // namespace tumble::judge
