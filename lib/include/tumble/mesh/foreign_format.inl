#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/foreign_format.hpp"

namespace tumble::detail {

TUMBLE_BODY std::string about_foreign_format(std::string_view bytes) {
  for (const Beginning& beginning : beginnings)
    if (bytes.starts_with(beginning.bytes))
      return std::string(": it begins like ") + beginning.what;
  return "";
}

}  // namespace tumble::detail
