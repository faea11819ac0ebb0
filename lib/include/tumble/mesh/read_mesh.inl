#pragma once

#include "tumble/mesh/read_mesh.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/mesh_format.hpp"
#include "tumble/mesh/parse_mesh.hpp"
#include "tumble/mesh/read_obj.hpp"

#ifndef __wasi__
namespace tumble {

TUMBLE_BODY parts::LabelledMesh read_mesh(const std::string& path) {
  std::ifstream file = detail::open_file(path);
  const std::size_t size = detail::size_of(file);
  std::string head(512, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  if (size > 0 && detail::format_of(head, size, path) == detail::MeshFormat::obj) {
    file.seekg(0);
    return detail::read_obj(file, path);
  }
  // A pipe cannot go back to its beginning.
  return parse_mesh(head + detail::read_all(file, size, path), path);
}

}  // namespace tumble
#endif
