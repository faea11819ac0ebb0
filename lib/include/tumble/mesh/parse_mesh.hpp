#pragma once
/// @file
/// A mesh file in memory, in any format that the library reads. Needs neither files nor streams.

#include <string_view>

#include "tumble/mesh/labelled_mesh.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// Reads OBJ, STL or PLY, whichever it is by its content. Faces of an OBJ file have the names that
/// it gives them; those of the others have none.
/// @param bytes of the file
/// @param name  what the file is called in messages; its ending counts only where the content says
///              nothing
/// @throws std::invalid_argument as parse_obj(), parse_stl() and parse_ply() do
parts::LabelledMesh parse_mesh(std::string_view bytes, std::string_view name);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/parse_mesh.inl"
#endif
