#pragma once
/// @file
/// Names that say which numbers of an answer are wrong, and how, but not why. Where anything else
/// is known, they are not given.

#include "judge/protocol/finding.hpp"
#include "judge/verdict/answer_type.hpp"

namespace tumble::judge {

/// Puts one of these names to a wrong answer that has none: "some wrong signs", "one wrong number",
/// "a wrong factor", "numbers in the wrong places", "one wrong row", "one wrong column", "some
/// wrong numbers". None of an answer that may be wrong by rounding or by too few steps, or that is
/// neither a struct nor a plain vector or matrix.
/// @param finding for inputs of no special kind: of a zero or an identity much is equal to much
void name_wrong_numbers(Finding& finding, const AnswerType& type = {});

/// Takes a name away that counts the places of a vector: this answer is none.
void drop_places(Finding& finding);

}  // namespace tumble::judge
