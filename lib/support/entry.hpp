#pragma once
/// @file
/// What is in a folder by a name, asked so that nothing a stranger puts there throws: a circle of
/// links, a name that is too long, a folder that may not be read.

#include <filesystem>
#include <system_error>

namespace tumble::support {

/// Whether there is anything by this name. A link is something, wherever it leads.
inline bool is_there(const std::filesystem::path& path) {
  std::error_code unreadable;
  return std::filesystem::exists(std::filesystem::symlink_status(path, unreadable));
}

/// Whether it is a file, and no link to one.
inline bool is_file(const std::filesystem::path& path) {
  std::error_code unreadable;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(path, unreadable));
}

}  // namespace tumble::support
