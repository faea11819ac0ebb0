#pragma once
/// @file
/// Mesh files: OBJ, STL and PLY. What is read and refused: see parse_obj.hpp, parse_stl.hpp and
/// parse_ply.hpp.

#include <string>

#include "tumble/mesh/labelled_mesh.hpp"
#include "tumble/mesh/parse_ply.hpp"
#include "tumble/mesh/parse_stl.hpp"
#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/read_file.hpp"

#ifndef __wasi__  // there are no files: parse_mesh() reads from memory
namespace tumble {

/// @addtogroup mesh
/// @{

namespace detail {

/// Reads a mesh from an STL file.
/// @throws std::runtime_error when the file cannot be read
/// @throws std::invalid_argument as parse_stl() does
inline PolygonMesh read_stl(const std::string& path) {
  return detail::parse_stl(detail::read_file(path), path);
}

/// Reads a mesh from a PLY file.
/// @throws std::runtime_error when the file cannot be read
/// @throws std::invalid_argument as parse_ply() does
inline PolygonMesh read_ply(const std::string& path) {
  return detail::parse_ply(detail::read_file(path), path);
}

}  // namespace detail

/// Reads a mesh from an OBJ, STL or PLY file, whichever it is by its content. Faces of an OBJ file
/// have the names that it gives them; those of the others have none.
/// @param path its ending counts only where the content says nothing
/// @throws std::runtime_error when the file cannot be read
/// @throws std::invalid_argument as parse_obj(), parse_stl() and parse_ply() do
parts::LabelledMesh read_mesh(const std::string& path);

/// @}

}  // namespace tumble
#endif

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/read_mesh.inl"
#endif
