#pragma once

#include "tumble/mesh/line_blocks.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/text_scanner.hpp"

namespace tumble::detail {

TUMBLE_BODY bool ends_line(std::string_view text, std::size_t length) {
  const char last = text[length - 1];
  const std::size_t body = text.substr(0, length).find_last_not_of("\r\n");
  if (body != std::string_view::npos && text[body] == '\\') return false;
  return last == '\n' || (last == '\r' && length < text.size() && text[length] != '\n');
}

TUMBLE_BODY std::size_t whole_lines(std::string_view text) {
  std::size_t length = text.size();
  while (length > 0 && !ends_line(text, length)) --length;
  return length;
}

}  // namespace tumble::detail
