#pragma once
/// @file
/// Whether a formula is one.

#include <string>

namespace tumble::book {

/// What is wrong with a formula: braces or environments that do not match, a command that neither
/// GitHub nor the site knows or that lacks an argument, an index of nothing, two of one kind, an &
/// where there are no columns. Empty if nothing is.
std::string mistake_in(const std::string& tex);

}  // namespace tumble::book
