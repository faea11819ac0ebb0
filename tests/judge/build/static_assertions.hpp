#pragma once
/// @file
/// Eigen checks sizes while a file is compiled, in its own headers: what a student has to read is
/// which line of theirs it was, and what is wrong with it.

#include <filesystem>
#include <string>

namespace tumble::judge {

/// The compiler's output, in which each static assertion that fails in a header is an error at the
/// place in `source` that led there, with that line of its `text`, one for a line. Elsewhere the
/// output stays as it is.
std::string static_assertions_at(const std::filesystem::path& source, const std::string& text,
                                 const std::string& compiler_output);

}  // namespace tumble::judge
