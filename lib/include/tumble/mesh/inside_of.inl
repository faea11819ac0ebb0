#pragma once

#include "tumble/mesh/inside_of.hpp"

#include <array>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/windings.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<Vec3> places_on_parts(const PolygonMesh& mesh, const Components& surface) {
  std::vector<Vec3> places;
  for (const std::array<int, 3>& t : widest_triangles(mesh, surface)) {
    const Vec3& a = mesh.vertex(t[0]);
    places.emplace_back(a + (mesh.vertex(t[1]) - a) / 3 + (mesh.vertex(t[2]) - a) / 3);
  }
  return places;
}

TUMBLE_BODY std::vector<char> inside_of(const PolygonMesh& body, const std::vector<Vec3>& places) {
  std::vector<char> result(places.size(), 0);
  if (body.face_count() == 0) return result;
  const Windings windings(body);
  for (std::size_t i = 0; i < places.size(); ++i) result[i] = windings.contains(places[i]);
  return result;
}

}  // namespace tumble::detail
