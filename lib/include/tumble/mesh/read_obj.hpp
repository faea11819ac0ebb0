#pragma once
/// @file
/// Wavefront OBJ files: see parse_obj.hpp for what is read and refused.

#include <istream>
#include <optional>
#include <stdexcept>
#include <string>

#include "tumble/core/require.hpp"
#include "tumble/mesh/line_blocks.hpp"
#include "tumble/mesh/parse_obj.hpp"
#include "tumble/mesh/read_file.hpp"

namespace tumble::detail {

/// Reads a mesh from a stream with an OBJ text.
/// @param name what the text is called in messages
/// @throws std::runtime_error when the stream fails
/// @throws std::invalid_argument as parse_obj() does
inline parts::LabelledMesh read_obj(std::istream& in, const std::string& name) {
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

#ifndef __wasi__
/// Reads a mesh from an OBJ file.
/// @throws std::runtime_error when the file cannot be read
/// @throws std::invalid_argument as parse_obj() does
inline parts::LabelledMesh read_obj(const std::string& path) {
  std::ifstream file = detail::open_file(path);
  return read_obj(file, path);
}
#endif

}  // namespace tumble::detail
