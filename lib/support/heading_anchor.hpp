#pragma once
/// @file
/// The names by which links reach the headings of a Markdown page.

#include <cctype>
#include <string>

namespace tumble::support {

/// GitHub's name for a heading: "What it costs" → "what-it-costs".
inline std::string heading_anchor(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto u = static_cast<unsigned char>(c);
    if (c == ' ')
      anchor += '-';
    else if (std::isalnum(u) != 0 || c == '-' || c == '_' || u >= 0x80)
      anchor += static_cast<char>(u < 0x80 ? std::tolower(u) : u);
  }
  return anchor;
}

}  // namespace tumble::support
