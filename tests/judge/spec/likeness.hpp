#pragma once
/// @file
/// Names for what a wrong answer is, as a whole, to the right one or to an argument.

#include <vector>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// "the argument as it came", "rows for columns", "the opposite sign", "places left at zero". Empty
/// if it is none of these.
/// @param finding for inputs of no special kind: of a zero or an identity much is equal to much
std::vector<Misconception> names_of_likeness(const Finding& finding);

/// The name of an answer that is one of the arguments.
inline constexpr const char* argument_as_it_came = "the argument as it came";

/// The name of an answer whose first or last numbers are 0.
inline constexpr const char* left_at_zero_name = "places left at zero";

Misconception argument_unchanged();

/// Whether an answer is this argument, of the same type and to the last digit.
bool is_unchanged(const Value& argument, const Value& answer);

/// Whether an answer is one of the arguments.
bool equals_argument(const List& arguments, const Value& answer);

/// What is said where places of a list were left out.
inline constexpr const char* look_at_the_loops =
    "Look at where your loops begin and end, and at the places that they write to.";

}  // namespace tumble::judge
