#pragma once

#include "tumble/mesh/read_obj.hpp"

#include <optional>
#include <stdexcept>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mesh/line_blocks.hpp"
#include "tumble/mesh/parse_obj.hpp"

namespace tumble::detail {

TUMBLE_BODY parts::LabelledMesh read_obj(std::istream& in, const std::string& name) {
  constexpr std::size_t block = 1 << 17;  // fits a core's cache
  std::optional<detail::ObjReader> reader;
  const bool all = detail::for_each_block_of_lines(in, block, [&](std::string_view text) {
    if (reader)
      reader->read(text);
    else
      reader.emplace(text, name);
  });
  if (!all) detail::throw_error<std::runtime_error>(name + ": cannot be read");
  return reader->mesh();
}

}  // namespace tumble::detail
