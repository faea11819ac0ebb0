#pragma once
/// @file
/// Which files `./tumble mass` is asked about.

#include <string>
#include <vector>

namespace tumble::scenes {

/// The mesh files that are meant: those given, and all in given folders, by name. Hidden files, and
/// the folders in a folder, are passed over.
/// @throws std::invalid_argument if a folder has none
std::vector<std::string> mesh_files(const std::vector<std::string>& given);

}  // namespace tumble::scenes
