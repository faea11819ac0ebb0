#pragma once
/// @file
/// Names for wrong answers that no exercise has for itself: they can be seen in any answer.

#include <vector>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// What a case asks with. Only of general inputs can be said what an answer is to them: of a zero
/// or an identity much is equal to much.
enum class Inputs { general, special };

/// What the numbers of a wrong answer show: "never set", "not a number", "infinite", "the opposite
/// sign", "rows for columns", "the argument as it came", "places left at zero". Empty if they show
/// nothing. They have no section of a page.
std::vector<Misconception> general_misconceptions(const Finding& finding, Inputs inputs);

/// The name of an answer that is one of the arguments.
inline constexpr const char* argument_as_it_came = "the argument as it came";

/// Whether an answer is one of the arguments that are lists.
bool equals_argument(const List& arguments, const Value& answer);

}  // namespace tumble::judge
