#pragma once
/// @file
/// Writes a zip, as platforms want feedback.

#include <filesystem>
#include <map>
#include <string>

namespace tumble::judge {

/// Whether zip files can be written here: not if tumble was built without libarchive.
bool can_write_zip();

/// Writes a zip with these texts by their paths: the same bytes for the same texts.
/// @throws std::runtime_error if it cannot be written
void write_zip(const std::filesystem::path& file, const std::map<std::string, std::string>& texts);

}  // namespace tumble::judge
