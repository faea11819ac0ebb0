#pragma once
/// @file
/// What students get wrong, as a page of the book: the sentences of all misconceptions.

#include <iosfwd>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Prints chapters/for_instructors/what_students_get_wrong.md: for each unit its misconceptions,
/// what the judge says to each, and a link to the section that explains it.
void print_misconceptions(std::ostream& out, const Course& course, const std::vector<Unit>& units);

}  // namespace tumble::judge
