#pragma once
/// @file
/// The curves of a student's engine, to go with a grade.

#include <functional>
#include <optional>
#include <string>

#include "judge/course/course.hpp"

namespace tumble::judge::mine {

/// The figure of `./tumble mine --fill`: what the student lacks is the solutions'.
/// @param source gives the student's file of a unit
/// @param folder for what is built
/// @return nothing if no function is the student's, or no engine can be made
std::optional<std::string> travelling_curve(const Course& course,
                                            const std::function<fs::path(const Unit&)>& source,
                                            const fs::path& folder);

}  // namespace tumble::judge::mine
