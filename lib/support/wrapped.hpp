#pragma once
/// @file
/// Text that is as wide as it looks, and lines that break between words.

#include <algorithm>
#include <sstream>
#include <string>

namespace tumble::support {

/// Characters, not bytes: the continuation bytes of UTF-8 are not counted.
inline std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The text in lines of at most `width` characters, all but the first indented. A longer word keeps
/// a line of its own.
inline std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string out;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    const std::size_t length = characters(word);
    const bool fits = out.empty() || column + 1 + length <= width;
    if (!out.empty()) out += fits ? " " : "\n" + std::string(indent, ' ');
    column = out.empty() ? length : (fits ? column + 1 : indent) + length;
    out += word;
  }
  return out;
}

}  // namespace tumble::support
