#include "judge/build/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <optional>

namespace tumble::judge {

namespace {

/// Where a text stops being one.
struct BadByte {
  std::size_t line;
  unsigned char byte;
};

/// The first byte that is not UTF-8 or is NUL, if there is one.
std::optional<BadByte> first_bad_byte(const std::string& text) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0) return BadByte{line, static_cast<unsigned char>(text[i])};
    if (text[i] == '\n') ++line;
    i += length;
  }
  return std::nullopt;
}

std::string why_no_text(const BadByte& bad) {
  const std::string line = "line " + std::to_string(bad.line);
  if (bad.byte == 0) return "has a NUL byte in " + line + ": save it as UTF-8 text";
  char byte[8];
  std::snprintf(byte, sizeof byte, "0x%02X", bad.byte);
  return std::string("is not UTF-8 text: see the byte ") + byte + " in " + line +
         ", and save it as UTF-8";
}

}  // namespace

std::size_t character_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  const unsigned first = byte(0), second = byte(1);
  if (first > 0 && first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return continues(1) ? 2 : 0;
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  if (overlong || no_character || !continues(1) || !continues(2)) return 0;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 && continues(3) ? 4 : 0;
}

std::string too_large(std::size_t size) {
  if (size <= largest_submission) return {};
  return "has " + std::to_string(size) + " bytes: more than the " +
         std::to_string(largest_submission) + " that a source file may have";
}

std::string reason_to_refuse(const std::string& text) {
  if (std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }))
    return "is empty";
  if (const auto bad = first_bad_byte(text)) return why_no_text(*bad);
  return {};
}

}  // namespace tumble::judge
