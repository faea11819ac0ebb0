#pragma once
/// @file
/// The part of a compiler's messages that is about the student's file.

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::judge {

/// Keeps the messages at places in `source` and, where `others`, the first line of errors
/// elsewhere; shortens paths to file names, and Eigen's types to the names that one writes. Nothing
/// of a foreign file's text gets through.
std::string messages_about(const std::filesystem::path& source, const std::string& compiler_output,
                           bool others);

/// A line of a message, in which types have the names that a beginner writes: gcc and clang tell
/// Eigen's with all of their parameters.
std::string with_short_types(const std::string& line);

/// Whether the compiler complains about a place in `source`, and not that it cannot work here.
bool has_error_in(const std::filesystem::path& source, const std::string& compiler_output);

/// In other words what a compiler's messages don't tell a beginner: lines, or nothing.
std::string advice_on(const std::string& compiler_output);

/// Whether the compiler's driver says, as its last word, that one of its programs was killed. What
/// a file says of it does not count: not a #warning, and not a line that is quoted.
bool says_that_it_was_killed(const std::string& compiler_output);

/// The functions that a linker misses, by name: "quaternions::inverse".
std::vector<std::string> undefined_functions(const std::string& linker_output);

/// A function's name without result, scope and types of Eigen: "cross". Others stay as they are.
std::string brief_name(const std::string& function);

/// The functions that a linker finds in more than one file.
std::vector<std::string> duplicate_functions(const std::string& linker_output);

}  // namespace tumble::judge
