#pragma once
/// @file
/// Which places lie in the inside of a body, and what is left of a mesh without some of its faces.

#include <array>
#include <vector>

#include "tumble/mesh/components.hpp"
#include "tumble/mesh/windings.hpp"

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
inline std::vector<Vec3> places_on_parts(const PolygonMesh& mesh, const Components& surface) {
  std::vector<Vec3> places;
  for (const std::array<int, 3>& t : widest_triangles(mesh, surface)) {
    const Vec3& a = mesh.vertex(t[0]);
    places.emplace_back(a + (mesh.vertex(t[1]) - a) / 3 + (mesh.vertex(t[2]) - a) / 3);
  }
  return places;
}

/// For each place whether it lies in the inside of a body.
/// @param body faces that are closed; may be none
inline std::vector<char> inside_of(const PolygonMesh& body, const std::vector<Vec3>& places) {
  std::vector<char> result(places.size(), 0);
  if (body.face_count() == 0) return result;
  const Windings windings(body);
  for (std::size_t i = 0; i < places.size(); ++i) result[i] = windings.contains(places[i]);
  return result;
}

}  // namespace tumble::detail
