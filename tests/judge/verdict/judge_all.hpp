#pragma once
/// @file
/// Judges many units: while the spec of one runs, the next files are compiled.

#include <filesystem>
#include <functional>
#include <vector>

#include "judge/course/course.hpp"
#include "judge/verdict/judge_unit.hpp"

namespace tumble::judge {

/// @param source gives the file of a unit
/// @param done   is called with each result, in the order of the units; not for those that are not
///               reached before the judgement's deadline
void judge_all(const Course& course, const std::vector<Unit>& units,
               const std::function<std::filesystem::path(const Unit&)>& source,
               const Judgement& judgement, const std::function<void(const UnitResult&)>& done);

}  // namespace tumble::judge
