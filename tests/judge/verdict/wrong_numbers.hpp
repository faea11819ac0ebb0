#pragma once
/// @file
/// Names that say which numbers of an answer are wrong, and how, but not why. Where anything else
/// is known, they are not given.

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// Puts one of these names to a wrong answer that has none: "some signs wrong", "one number wrong",
/// "off by a factor", "numbers at wrong places", "one row wrong", "one column wrong", "some numbers
/// wrong".
/// @param finding for inputs of no special kind: of a zero or an identity much is equal to much
void name_wrong_numbers(Finding& finding);

}  // namespace tumble::judge
