#pragma once

#include "tumble/mesh/parse_stl.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/parse_binary_stl.hpp"
#include "tumble/mesh/parse_text_stl.hpp"

namespace tumble::detail {

TUMBLE_BODY bool is_text_stl(std::string_view head) {
  TextScanner text(head, "");
  text.skip_to_word();
  return is_keyword(text.peek_word(), "solid") &&
         without_padding(head).find('\0') == std::string_view::npos;
}

TUMBLE_BODY PolygonMesh parse_stl(std::string_view bytes, std::string_view name) {
  const bool is_text =
      is_text_stl(bytes) || (!bytes.empty() && bytes.find('\0') == std::string_view::npos);
  if (is_text && !detail::is_binary_stl(bytes, bytes.size()))
    return detail::StlTextReader(without_padding(bytes), name).read();
  return detail::parse_binary_stl(bytes, name);
}

}  // namespace tumble::detail
