#pragma once
/// @file
/// Formulas in Markdown: where they are in a line, and what Markdown would do to them.

#include <cstddef>
#include <string>
#include <vector>

namespace tumble::book {

/// A formula between dollars: `$x$`, or `` $`x`$ ``, which Markdown leaves alone.
struct InlineFormula {
  std::size_t begin = 0, end = 0;  ///< of the whole, with its dollars
  std::string tex;
};

/// The formulas of a line that is outside of fences. A dollar followed by a blank or preceded by
/// one is a dollar, and so is what is in a code span.
std::vector<InlineFormula> formulas_in(const std::string& line);

/// What GitHub's Markdown would change in `$…$` before the formula is set, such as \, or \{
/// (escapes) or }_ (emphasis): such a formula has to be written with backticks. Empty if nothing.
std::string markdown_trap_in(const std::string& tex);

/// The line with Doxygen's formulas; what touches one, such as a comma behind it, stays in its
/// line.
std::string with_formulas(const std::string& text);

}  // namespace tumble::book
