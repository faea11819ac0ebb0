#pragma once
/// @file
/// Which places lie in the inside of a body, and what is left of a mesh without some of its faces.

#include <vector>

#include "tumble/mesh/components.hpp"

namespace tumble::detail {

/// Some faces of a mesh.
struct SomeFaces {
  PolygonMesh mesh;          ///< with all vertices
  std::vector<int> numbers;  ///< which faces of the whole mesh they are

  /// Those of which `chosen(face)` says so.
  template <class Chosen>
  SomeFaces(const PolygonMesh& whole, const Chosen& chosen) {
    mesh.vertices = whole.vertices;
    for (int f = 0; f < whole.face_count(); ++f) {
      if (whole.face(f).empty() || !chosen(f)) continue;
      mesh.add_face(whole.face(f));
      numbers.push_back(f);
    }
  }
};

/// The middle of a triangle of each part: the one that looks largest from above.
std::vector<Vec3> places_on_parts(const PolygonMesh& mesh, const Components& surface);

/// For each place whether it lies in the inside of a body.
/// @param body faces that are closed; may be none
std::vector<char> inside_of(const PolygonMesh& body, const std::vector<Vec3>& places);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/inside_of.inl"
#endif
