#pragma once
/// @file
/// The verdicts that a grading has left on disk, and where two of them differ.

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tumble::bench {

using nlohmann::json;

/// By the unit's id.
using Verdicts = std::map<std::string, json>;
/// By the student's name.
using ClassVerdicts = std::map<std::string, Verdicts>;

/// What `tumble_judge grade --out grades` has written so far.
ClassVerdicts verdicts_of_class(const std::filesystem::path& grades);

/// What `tumble_judge check --json file` has written.
Verdicts verdicts_of_check(const std::filesystem::path& file);

std::size_t count(const ClassVerdicts& all);

/// How alike two verdicts have to be.
enum class Likeness {
  all,     ///< in all but the time that they took
  laws,    ///< in each law; not in words that name paths and lines
  outcome  ///< whether it passes, and the word for it if not
};

bool alike(json a, json b, Likeness likeness);

/// The verdicts of `some` that `all` has not, or has otherwise: "s0003 4.1: wrong, passed".
/// @param likeness of a student's verdict on a unit
std::vector<std::string> differences(
    const ClassVerdicts& some, const ClassVerdicts& all,
    const std::function<Likeness(const std::string& student, const std::string& unit)>& likeness);

}  // namespace tumble::bench
