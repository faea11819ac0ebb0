#include "judge/build/text_encoding.hpp"

#include <array>

#include "judge/build/source_text.hpp"
#include "judge/build/utf16.hpp"

namespace tumble::judge {

namespace {

/// A byte of 0x80 or more as UTF-8 (Source: the WHATWG's and Microsoft's table of code page 1252).
/// Five of them mean nothing there.
std::string utf8_of_windows_1252(unsigned char byte) {
  static constexpr std::array<const char*, 32> below_latin_1 = {
      "\u20ac", "\ufffd", "\u201a", "\u0192", "\u201e", "\u2026", "\u2020", "\u2021",
      "\u02c6", "\u2030", "\u0160", "\u2039", "\u0152", "\ufffd", "\u017d", "\ufffd",
      "\ufffd", "\u2018", "\u2019", "\u201c", "\u201d", "\u2022", "\u2013", "\u2014",
      "\u02dc", "\u2122", "\u0161", "\u203a", "\u0153", "\ufffd", "\u017e", "\u0178"};
  if (byte < 0xa0) return below_latin_1[byte - 0x80];
  return {static_cast<char>(0xc0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3f))};
}

}  // namespace

DecodedText decoded(const std::string& bytes) {
  if (auto text = utf8_of_utf16(bytes)) return {std::move(*text), "UTF-16"};
  if (bytes.find('\0') != std::string::npos) return {bytes, ""};
  DecodedText result;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = character_length(bytes, i);
    if (length > 0) {
      result.text.append(bytes, i, length);
    } else {
      result.text += utf8_of_windows_1252(static_cast<unsigned char>(bytes[i]));
      result.was = "Windows-1252";
    }
    i += length > 0 ? length : 1;
  }
  return result;
}

}  // namespace tumble::judge
