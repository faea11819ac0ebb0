#pragma once
/// @file
/// Judges many units, each in a process of its own: where the judge itself fails at one, by
/// whatever its answers make of it, the others are judged all the same, and the verdict says so.

#include <filesystem>
#include <functional>
#include <vector>

#include "judge/course/course.hpp"
#include "judge/verdict/judge_unit.hpp"

namespace tumble::judge {

/// The verdicts; UnitResult::judge_failure says of which of them the judge has failed.
/// @param source gives the file of a unit
/// @param done   is called with each result, in the order of the units; not for those that are not
///               reached before the judgement's deadline
void judge_all(const Course& course, const std::vector<Unit>& units,
               const std::function<std::filesystem::path(const Unit&)>& source,
               const Judgement& judgement, const std::function<void(const UnitResult&)>& done);

}  // namespace tumble::judge
