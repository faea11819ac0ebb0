#pragma once
/// @file
/// Wavefront OBJ files: see parse_obj.hpp for what is read and refused.

#include <istream>
#include <string>

#include "tumble/mesh/labelled_mesh.hpp"
#include "tumble/mesh/read_file.hpp"

namespace tumble::detail {

/// Reads a mesh from a stream with an OBJ text.
/// @param name what the text is called in messages
/// @throws std::runtime_error when the stream fails
/// @throws std::invalid_argument as parse_obj() does
parts::LabelledMesh read_obj(std::istream& in, const std::string& name);

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

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/read_obj.inl"
#endif
