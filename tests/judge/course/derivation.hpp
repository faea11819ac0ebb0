#pragma once
/// @file
/// Where the book derives what a unit asks for.

#include <string>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// The heading, on the chapter's page, of the section that ends with **Now write 4.1**; empty if
/// the page is not there, or does not have this unit.
std::string derivation_of(const Course& course, const Unit& unit);

}  // namespace tumble::judge
