#pragma once
/// @file
/// What is wrong in a student's file may be found in a header, as when Eigen checks sizes: what a
/// student has to read is which line of theirs it was, and what is wrong with it.

#include <filesystem>
#include <string>

namespace tumble::judge {

/// The compiler's output, in which each error in a header is one at the place in `source` that led
/// there, with that line of its `text`: the first of a line, for the others follow from it.
/// Elsewhere the output stays as it is.
std::string header_errors_at(const std::filesystem::path& source, const std::string& text,
                             const std::string& compiler_output);

}  // namespace tumble::judge
