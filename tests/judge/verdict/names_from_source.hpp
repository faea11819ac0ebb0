#pragma once
/// @file
/// Names for wrong answers that the student's file shows, beside the numbers: a float, a quotient
/// of whole numbers.

#include <optional>
#include <string>
#include <vector>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// Whether an auto holds what an expression gives ("auto x = a * b"), which with Eigen may be the
/// expression itself: not a lambda, and not a reference.
bool keeps_an_expression(const std::string& source);

/// Such an auto: the number of its line, from 1, and its name.
struct KeptExpression {
  std::size_t line;
  std::string name;
};
std::vector<KeptExpression> kept_expressions(const std::string& source);

/// What is said where a sanitizer stops at memory that is gone, behind such an auto.
/// @param place "euler_step.cpp:7: stack-use-after-scope"
std::optional<Misconception> expression_that_outlives(const std::string& source,
                                                      const std::string& place);

/// Puts a name to a wrong answer for which `source` holds the reason:
/// - "whole-number division": 1/2 or 1/12 is there, which is 0: a quotient of two numbers, not
///   h * 1/2. It replaces other names, which take the factor that is missing for something else;
/// - "input that is not there": it reads std::cin, and the answer has no name or one of memory that
///   was never set;
/// - "float": the numbers are right to some 7 digits, and there is a float (or 0.5f, or sqrtf).
void name_from_source(Finding& finding, const std::string& source);

/// "a rounded constant": `source` has 0.1667 for 1/6, and the answer is off by about as much.
/// Only where nothing else is known, a variable that was never set for one.
void name_rounded_constant(Finding& finding, const std::string& source);

}  // namespace tumble::judge
