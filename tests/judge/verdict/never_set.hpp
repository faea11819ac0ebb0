#pragma once
/// @file
/// Variables that the compiler sees used before they are set.

#include <optional>
#include <string>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// A variable of the student's file that may be used before it is set.
struct NeverSet {
  std::string variable;  ///< "largest", "body.mass"
  std::string place;     ///< "energy_drift.cpp:18"
};

/// The first one that a compiler's warnings about a file name, or nothing.
/// @param file the student's, without its folder
std::optional<NeverSet> never_set_in(const std::string& warnings, const std::string& file);

/// Whether a number is declared without a value in the code of `source`: "double x;". It may be
/// set later; a compiler is worth asking.
bool declares_without_value(const std::string& source);

/// Names the variable in a wrong answer that has the mark of memory that was never set, or no name
/// at all.
void name_variable(Finding& finding, const NeverSet& variable);

}  // namespace tumble::judge
