#pragma once
/// @file
/// Verdicts in a terminal.

#include <iosfwd>

#include "judge/course/course.hpp"
#include "judge/verdict/unit_result.hpp"

namespace tumble::judge {

/// How much is said, and whether in colour.
struct ConsoleStyle {
  bool colour = false;
  bool every_case = false;  ///< explain every case that fails, not only the first
};

/// Colour on a terminal, unless NO_COLOR is set.
ConsoleStyle style_of_terminal();

/// One line with the verdict, and below it why.
void print_result(std::ostream& out, const Course& course, const UnitResult& result,
                  const ConsoleStyle& style);

/// One line only: for a chapter.
void print_line(std::ostream& out, const UnitResult& result, const ConsoleStyle& style);

}  // namespace tumble::judge
