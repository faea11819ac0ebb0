#pragma once
/// @file
/// Names for wrong answers that the student's file shows, beside the numbers: a float, a quotient
/// of whole numbers.

#include <string>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// The code without what the compiler skips: each character of a comment, of a text or behind
/// #if 0 is a blank.
std::string code_of(const std::string& source);

/// Whether the code of `source` contains `word`: not in comments, texts, or as a part of another
/// word.
bool mentions(const std::string& source, const std::string& word);

/// Whether an auto holds what an expression gives ("auto x = a * b"), which with Eigen may be the
/// expression itself: not a lambda, and not a reference.
bool keeps_an_expression(const std::string& source);

/// Puts a name to a wrong answer for which `source` holds the reason:
/// - "whole-number division": 1/2 or 1/12 stands there, which is 0: a quotient of two numbers, not
///   h * 1/2. It replaces other names, which take the factor that is missing for something else;
/// - "float": the numbers are right to some 7 digits, and there is a float (or 0.5f, or sqrtf).
void name_from_source(Finding& finding, const std::string& source);

}  // namespace tumble::judge
