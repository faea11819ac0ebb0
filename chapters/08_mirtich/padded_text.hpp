#pragma once
/// @file
/// Text in lines of a given width.

#include <sstream>
#include <string>
#include <vector>

#include "common.hpp"

namespace mirtich_chapter {

/// Words in lines of at most `width` characters.
inline std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t room = support::characters(lines.back()) + 1 + support::characters(word);
    if (!lines.back().empty() && room > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

/// Pads a line, so that a table whose columns are flush right shows it flush left.
inline std::string padded(const std::string& line, std::size_t width) {
  return line + std::string(width - support::characters(line), ' ');
}

}  // namespace mirtich_chapter
