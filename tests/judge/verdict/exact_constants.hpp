#pragma once
/// @file
/// The proof that a rounded constant is the mistake: with the exact one, the answers are right.
/// Digits can look like those of a constant by chance.

#include "judge/build/job.hpp"
#include "judge/spec/run.hpp"
#include "judge/verdict/unit_result.hpp"

namespace tumble::judge {

/// Takes the name "a rounded constant" from each case that fails with exact constants as well.
/// @param run what gave this result
void drop_unproven_constants(UnitResult& result, const Job& job, const SpecRun& run);

}  // namespace tumble::judge
