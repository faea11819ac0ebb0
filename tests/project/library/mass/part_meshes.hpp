#pragma once
/// @file
/// Meshes whose faces have names.

#include <string>
#include <utility>
#include <vector>

#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/labelled_mesh.hpp"

namespace tumble::test {

/// Some meshes as one, each in the material of its name.
inline parts::LabelledMesh of_materials(
    const std::vector<std::pair<std::string, PolygonMesh>>& materials) {
  PolygonMesh all;
  detail::LabelReader labels;
  for (const auto& [name, mesh] : materials) {
    labels.set(&parts::Label::material, name, all.face_count());
    all = together(all, mesh);
  }
  return labels.put_on(all);
}

}  // namespace tumble::test
