#pragma once
/// @file
/// Pages of the course as they are handed out: they speak of what is there.

#include <filesystem>
#include <set>
#include <string>

namespace tumble::judge {

/// A page without its links to what is not handed out: their words stay. A row of a table, an item
/// of a list, or one between · and · that begins with such a link is about what is not there, and
/// is left out as a whole.
/// @param path  where it is, from the root
/// @param paths all files that are handed out, from the root
std::string without_dead_links(const std::string& text, const std::filesystem::path& path,
                               const std::set<std::filesystem::path>& paths);

}  // namespace tumble::judge
