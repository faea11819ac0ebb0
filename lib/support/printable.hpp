#pragma once
/// @file
/// Texts of others on a terminal: it would obey control characters, so they are shown instead.

#include <array>
#include <cstdio>
#include <string>

namespace tumble::support {

/// How many bytes from here on are one character that a terminal would obey and not show: 0 if it
/// shows it, or it is the end of a line or a tab.
inline std::size_t unprintable_bytes(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
  };
  if ((byte(0) < 0x20 && byte(0) != '\n' && byte(0) != '\t') || byte(0) == 0x7f) return 1;
  if (byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0) return 2;  // C1: CSI and the like
  const bool general = byte(0) == 0xe2;  // U+2028 to U+202E and U+2066 to U+2069: direction, lines
  if (general && byte(1) == 0x80 && byte(2) >= 0xa8 && byte(2) <= 0xae) return 3;
  if (general && byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9) return 3;
  return 0;
}

/// "\x1B" for each such byte; a message keeps its lines.
inline std::string printable(const std::string& text) {
  std::string shown;
  for (std::size_t i = 0, bad = 0; i < text.size(); ++i) {
    if (bad == 0) bad = unprintable_bytes(text, i);
    if (bad == 0) {
      shown += text[i];
      continue;
    }
    std::array<char, 8> code{};
    std::snprintf(code.data(), code.size(), "\\x%02X",
                  static_cast<unsigned>(static_cast<unsigned char>(text[i])));
    shown += code.data();
    --bad;
  }
  return shown;
}

/// The same on one line, for a name inside a line or a table: "two\nlines".
inline std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : printable(name))
    text += c == '\n' ? "\\n" : c == '\t' ? "\\t" : std::string(1, c);
  return text;
}

}  // namespace tumble::support
