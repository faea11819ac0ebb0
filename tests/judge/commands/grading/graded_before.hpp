#pragma once
/// @file
/// What a folder of results keeps of the command that graded into it. What a later command leaves
/// out is as it was before: else the grades of a class would change without a word.

#include <optional>
#include <string>

#include "judge/class/grade_class.hpp"
#include "judge/commands/commands.hpp"

namespace tumble::judge {

/// A file's text, if there is one.
std::optional<std::string> text_of(const std::optional<fs::path>& file);

/// The options with what they leave out and the folder has: submissions and their platform,
/// settings, roster.
/// @param taken gets what was taken, as it would be given: "--course grades/course.json, …"
GradeOptions as_before(GradeOptions options, std::string& taken);

/// Says in what the settings and the roster differ from those that the class was graded with.
/// @throws std::invalid_argument if they do, and only a part of the class is to be judged
void say_what_differs(const GradeOptions& options);

/// Keeps for the next time what the class is graded with.
void keep(const GradesFolder& folder, const GradeOptions& options);
/// The same of the texts of the files alone; without one, none is there then.
void keep_files(const GradesFolder& folder, const std::optional<std::string>& settings,
                const std::optional<std::string>& roster);

}  // namespace tumble::judge
