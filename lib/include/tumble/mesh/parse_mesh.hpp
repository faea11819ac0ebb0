#pragma once
/// @file
/// A mesh file in memory, in any format that the library reads. Needs neither files nor streams.

#include <string_view>

#include "tumble/mesh/mesh_format.hpp"
#include "tumble/mesh/parse_obj.hpp"
#include "tumble/mesh/parse_ply.hpp"
#include "tumble/mesh/parse_stl.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// Reads OBJ, STL or PLY, whichever it is by its content. Faces of an OBJ file have the names that
/// it gives them; those of the others have none.
/// @param bytes of the file
/// @param name  what the file is called in messages; its ending counts only where the content says
///              nothing
/// @throws std::invalid_argument as parse_obj(), parse_stl() and parse_ply() do
inline parts::LabelledMesh parse_mesh(std::string_view bytes, std::string_view name) {
  switch (detail::format_of(bytes, bytes.size(), name)) {
    case detail::MeshFormat::stl:
      return parts::LabelledMesh(detail::parse_stl(bytes, name));
    case detail::MeshFormat::ply:
      return parts::LabelledMesh(detail::parse_ply(bytes, name));
    default:
      return detail::parse_obj(bytes, name);
  }
}

/// @}

}  // namespace tumble
