#pragma once
/// @file
/// Text files that the judge keeps for people: read whole, written whole or not at all.

#include <filesystem>
#include <string>

namespace tumble::judge {

/// @throws std::runtime_error naming the file if it cannot be read
std::string read_text(const std::filesystem::path& file);

/// Writes beside the file and then puts it in its place: whoever is interrupted, or out of space,
/// keeps what was there.
/// @throws std::runtime_error naming the file if it cannot be written
void write_text(const std::filesystem::path& file, const std::string& text);

/// The same, in folders that need not be there.
void write_text_and_folders(const std::filesystem::path& file, const std::string& text);

}  // namespace tumble::judge
