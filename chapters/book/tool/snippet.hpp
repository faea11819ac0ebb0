#pragma once
/// @file
/// Code in a page is a definition of the compiled source, found by its name.

#include <filesystem>
#include <string>

namespace tumble::book {

/// The definition of `name` in a source file, without its documentation: a function, struct, class,
/// concept or variable that starts in the first column; "Class::member" for a member; "*" for the
/// whole file without the comment that opens it.
/// @throws std::invalid_argument naming the file if it is not there
std::string snippet(const std::filesystem::path& file, const std::string& name);

/// The same up to the body: what a page shows of a function that is an exercise.
std::string signature(const std::filesystem::path& file, const std::string& name);

}  // namespace tumble::book
