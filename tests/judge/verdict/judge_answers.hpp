#pragma once
/// @file
/// From answers to the verdict on them. The answers come from a process, or from a page.

#include <cstdint>

#include "judge/build/build_outcome.hpp"
#include "judge/spec/answerer.hpp"
#include "judge/verdict/answer_type.hpp"
#include "judge/verdict/unit_result.hpp"

namespace tumble::judge {

/// Which inputs an answerer is tried with.
struct Trial {
  std::uint64_t seed = 1;
  int seeds = 1;              ///< how many, from `seed` on; the first that fails is reported
  std::size_t only_case = 0;  ///< 0: all of them
};

/// The verdict on a file before any question is asked.
UnitResult result_of_build(const Unit& unit, const std::filesystem::path& source,
                           const BuildReport& build);

/// Runs the spec of the unit, one seed after another until one fails.
void judge_answers(UnitResult& result, const Trial& trial, Answerer& answerer);

/// Puts the names to wrong answers for which the file itself holds the reason.
void name_from_source(UnitResult& result, const std::string& source);

/// Names a constant with few digits, where nothing else is known of a wrong answer. It is a guess
/// until drop_unproven_constants() has tried the exact one.
void name_rounded_constant(UnitResult& result, const std::string& source);

/// Says which numbers of the first case's answer are wrong, where nothing else is known of it.
void name_wrong_numbers(UnitResult& result, const AnswerType& type);

}  // namespace tumble::judge
