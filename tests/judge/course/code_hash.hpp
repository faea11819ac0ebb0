#pragma once
/// @file
/// A number that changes with the code of the judge.

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tumble::judge {

/// The code files (.hpp, .cpp) of a folder, in the order of their names; none if it is not there.
std::vector<std::filesystem::path> code_in(const std::filesystem::path& folder);

/// The same, with those of the folders in it.
std::vector<std::filesystem::path> code_below(const std::filesystem::path& folder);

/// Of the names and texts of these files.
std::uint64_t code_hash(const std::vector<std::filesystem::path>& files, std::uint64_t start);

}  // namespace tumble::judge
