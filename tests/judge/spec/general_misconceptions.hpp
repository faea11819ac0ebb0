#pragma once
/// @file
/// Names for wrong answers that no exercise has for itself: they can be seen in any answer.

#include <vector>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// What a case asks with. Only of general inputs can be said what an answer is to them: of a zero
/// or an identity much is equal to much.
enum class Inputs { general, special };

/// What the numbers of a wrong answer show: "never set", "not a number", "infinite", and of general
/// inputs what names_of_likeness() knows. Empty if they show nothing. They have no section of a
/// page.
std::vector<Misconception> general_misconceptions(const Finding& finding, Inputs inputs);

}  // namespace tumble::judge
