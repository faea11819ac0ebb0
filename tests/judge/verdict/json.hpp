#pragma once
/// @file
/// Verdicts as JSON, for other programs.

#include <filesystem>
#include <vector>

#include "judge/verdict/unit_result.hpp"

namespace tumble::judge {

/// Writes all results so far: to a file beside it first, then renamed, so that there is always a
/// complete one.
/// @throws std::runtime_error if it cannot be written
void write_json(const std::filesystem::path& file, const std::vector<UnitResult>& results);

}  // namespace tumble::judge
