#pragma once

#include "tumble/mesh/text_scanner.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY bool is_keyword(std::string_view word, std::string_view keyword) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  if (word == keyword) return true;
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [&](char a, char b) { return lower(a) == b; });
}

TUMBLE_BODY std::string_view without_padding(std::string_view text) {
  const std::size_t last = text.find_last_not_of(std::string_view("\0\x1A \t\r\n", 6));
  const std::size_t end = last == std::string_view::npos ? 0 : last + 1;
  return text.substr(0, text.find_first_of(std::string_view("\0\x1A", 2), end));
}

TUMBLE_BODY std::string shown(std::string_view word) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  std::size_t most = 40;
  while (most > 0 && most < word.size() && (word[most] & 0xC0) == 0x80) --most;  // between letters
  for (const char c : word.substr(0, most)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F)
      text += c;
    else
      text += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
  }
  return text;
}

}  // namespace tumble::detail
