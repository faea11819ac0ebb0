#pragma once

#include "tumble/mesh/obj_keywords.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/text_scanner.hpp"

namespace tumble::detail {

TUMBLE_BODY std::string_view obj_keyword_like(std::string_view word) {
  for (const std::string_view keyword : obj_read)
    if (is_keyword(word, keyword)) return keyword;
  for (const std::string_view keyword : obj_passed_over)
    if (is_keyword(word, keyword)) return keyword;
  return {};
}

}  // namespace tumble::detail
