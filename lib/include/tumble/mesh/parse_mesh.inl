#pragma once

#include "tumble/mesh/parse_mesh.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/mesh_format.hpp"
#include "tumble/mesh/parse_obj.hpp"
#include "tumble/mesh/parse_ply.hpp"
#include "tumble/mesh/parse_stl.hpp"

namespace tumble {

TUMBLE_BODY parts::LabelledMesh parse_mesh(std::string_view bytes, std::string_view name) {
  switch (detail::format_of(bytes, bytes.size(), name)) {
    case detail::MeshFormat::stl:
      return parts::LabelledMesh(detail::parse_stl(bytes, name));
    case detail::MeshFormat::ply:
      return parts::LabelledMesh(detail::parse_ply(bytes, name));
    default:
      return detail::parse_obj(bytes, name);
  }
}

}  // namespace tumble
