#pragma once
/// @file
/// Submissions that come packed. An archive is a stranger's file like any other: it is read by a
/// process behind walls that can write nothing, and what leaves that process is text.

#include <filesystem>
#include <map>
#include <string>

namespace tumble::judge {

namespace fs = std::filesystem;

/// The source files of an archive by their paths in it, or why it is not looked at.
struct Unpacked {
  std::map<std::string, std::string> files;
  std::string refused;  ///< empty if it was read
};

/// Limits of what is unpacked at all.
inline constexpr std::size_t largest_archive = 32u << 20, largest_content = 256u << 20,
                             most_entries = 20'000;

/// Reads an archive's .cpp files. Refused are archives with a path that leads out of them, a link
/// or a device, more than 20,000 entries, 256 MB of content or 32 MB packed, or that are damaged or
/// encrypted.
/// @throws std::runtime_error if the judge itself is broken
Unpacked unpack(const fs::path& archive);

}  // namespace tumble::judge
