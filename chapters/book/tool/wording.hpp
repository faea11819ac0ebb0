#pragma once
/// @file
/// What a sentence has otherwise on the site than on GitHub.

#include <string>

namespace tumble::book {

/// A line of a page as the site shows it: a number stays with its unit, and "…" is “…”, because
/// Doxygen leaves formulas between straight quotes alone. Code and formulas stay as they are.
std::string on_the_site(const std::string& text);

}  // namespace tumble::book
