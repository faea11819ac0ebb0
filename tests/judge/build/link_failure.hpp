#pragma once
/// @file
/// What it means for a student's file that the linker does not accept it.

#include <string>

#include "judge/build/build_outcome.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge {

/// Says in `report`, whose outcome is “does not compile”, what is missing by the linker's words. If
/// that is the function of the contract itself, the outcome is “wrong signature”.
/// @param functions what the file defines, for whom a letter or a type is wrong; empty if that is
///                  not known
/// @param source    the text of the file, which may show why other files can't see the function
void explain_link_failure(BuildReport& report, const Course& course, const Unit& unit,
                          const std::string& linker_output,
                          const std::vector<std::string>& functions, const std::string& source);

}  // namespace tumble::judge
