#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/obj_elsewhere.hpp"

namespace tumble::detail {

TUMBLE_BODY const char* what_is_elsewhere(std::string_view keyword) {
  for (const ObjElsewhere& line : obj_elsewhere)
    if (line.keyword == keyword) return line.what;
  return nullptr;
}

}  // namespace tumble::detail
