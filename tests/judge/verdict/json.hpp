#pragma once
/// @file
/// Verdicts as JSON, for other programs.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "judge/verdict/unit_record.hpp"

namespace tumble::judge {

/// {"unit": …, "passed": …, …, "cases": […]}
nlohmann::ordered_json json_of(const UnitRecord& record);

/// The inverse.
/// @throws nlohmann::json::exception if something is missing or of another type
UnitRecord unit_record_of(const nlohmann::ordered_json& json);

/// Text that can be written: what a student's code prints need not be UTF-8.
std::string text_of(const nlohmann::ordered_json& json);

/// Writes all results. Called after each unit, the file is valid and complete at any time.
void write_json(const std::filesystem::path& file, const std::vector<UnitRecord>& records);

}  // namespace tumble::judge
