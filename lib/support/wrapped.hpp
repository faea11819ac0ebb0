#pragma once
/// @file
/// Text that is as wide as it looks, and lines that break between words.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace tumble::support {

/// Characters, not bytes: the continuation bytes of UTF-8 are not counted.
inline std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The words of the text in lines of at most `width` characters, all but the first `indent`
/// characters shorter. A longer word keeps a line of its own.
inline std::vector<std::string> lines_of(const std::string& text, std::size_t width,
                                         std::size_t indent = 0) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t room = width - (lines.size() == 1 ? 0 : std::min(width, indent));
    const std::size_t wanted = characters(lines.back()) + 1 + characters(word);
    if (!lines.back().empty() && wanted > room) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

/// The same as one text, all lines but the first indented.
inline std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string out;
  for (const std::string& line : lines_of(text, width, indent))
    out += (out.empty() ? "" : "\n" + std::string(indent, ' ')) + line;
  return out;
}

/// The text with spaces behind it, to `width` characters if it is shorter.
inline std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, characters(text)), ' ');
}

}  // namespace tumble::support
