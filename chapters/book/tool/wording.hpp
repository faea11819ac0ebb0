#pragma once
/// @file
/// What a sentence has otherwise on the site than on GitHub.

#include <string>

namespace tumble::book {

/// What a cell of a table says: it breaks between words, and not in a formula, a short bracket or a
/// unit.
std::string with_whole_formulas(const std::string& words);

/// Words in which a symbol's index is below: v_z, K_zz, ω_y.
std::string with_indices(const std::string& words);

/// A line of a page as the site shows it: a number stays with its unit, a vector in
/// one line, and "…" is “…”, because
/// Doxygen leaves formulas between straight quotes alone. Code and formulas stay as they are.
std::string on_the_site(const std::string& text);

}  // namespace tumble::book
