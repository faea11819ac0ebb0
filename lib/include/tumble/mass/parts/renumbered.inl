#pragma once

#include "tumble/mass/parts/renumbered.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

TUMBLE_BODY bool counts_vertices(std::string_view words) {
  const auto last = [words](const char* noun) {
    const std::size_t at = words.rfind(noun);
    return at == std::string_view::npos ? -1 : static_cast<std::ptrdiff_t>(at);
  };
  return std::max(last("edge"), last("vertex")) > last("face");
}

}  // namespace tumble::detail
